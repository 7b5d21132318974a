// A ray for every pixel; its direction is its colour.
#include "common/stage.hpp"
#include "common/vector.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"

namespace rt {

std::function<Ray(Pixel)> pixel_rays(const Camera& camera, Resolution resolution) {
    const Real fov = vertical_fov(camera, resolution);
    return [=](Pixel pixel) { return camera_ray(pixel, resolution, fov); };
}

Color trace(const Scene& /*scene*/, const Ray& ray, Context& context) {
    ++context.rays;
    return (unit(ray.direction) + Real(1)) / Real(2);  // red to the right, green upwards
}

}  // namespace rt
