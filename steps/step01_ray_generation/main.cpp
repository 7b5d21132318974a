// A ray for every pixel; the color shows its direction.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

PixelRays pixel_rays(const Camera& camera, Resolution resolution) {
    return {.resolution = resolution, .vertical_fov = vertical_fov(camera, resolution)};
}

Ray PixelRays::operator()(Pixel pixel) const {
    return camera_ray(pixel, resolution, vertical_fov);
}

Color trace(const Scene& /*scene*/, const Ray& ray, Context& context) {
    ++context.rays;
    return (unit(ray.direction) + Real(1)) / Real(2);  // red to the right, green up
}

}  // namespace rt
