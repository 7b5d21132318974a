// The rays of every picture from this stage on.
#include "common/render/stage.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

PixelRays pixel_rays(const Camera& camera, Resolution resolution) {
    return {.resolution = resolution,
            .vertical_fov = vertical_fov(camera, resolution),
            .basis = camera_basis(camera.direction),
            .position = camera.position};
}

Ray PixelRays::operator()(Pixel pixel) const {
    return to_world(camera_ray(pixel, resolution, vertical_fov), basis, position);
}

std::optional<Image> picture_by_own_loop(const Scene& /*scene*/) {
    return std::nullopt;
}

}  // namespace rt
