#include "common/scene/scene.hpp"

#include <cmath>

namespace rt {

Real vertical_fov(const Camera& camera, Resolution resolution) {
    if (camera.fov_axis == FovAxis::vertical) return camera.fov;
    const Real ratio = Real(resolution.height) / Real(resolution.width);
    return 2 * std::atan(std::tan(camera.fov / 2) * ratio);
}

}  // namespace rt
