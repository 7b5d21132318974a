// From here on every picture is made of these rays.
#include "common/stage.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

std::function<Ray(Pixel)> pixel_rays(const Camera& camera, Resolution resolution) {
    const Real fov = vertical_fov(camera, resolution);
    const Basis basis = camera_basis(camera.direction);
    return [=, position = camera.position](Pixel pixel) {
        return to_world(camera_ray(pixel, resolution, fov), basis, position);
    };
}

}  // namespace rt
