#include "common/program/turntable.hpp"

#include "common/scene/scene.hpp"

#include <cmath>

namespace rt {

std::optional<Vec3> RT_PRECISION::middle_of_shapes(const Scene& scene) {
    const BoundingBox box = box_of_shapes(scene);
    if (!(box.min.x <= box.max.x)) return std::nullopt;
    return box.min / Real(2) + box.max / Real(2);
}

Camera RT_PRECISION::turned(Camera camera, Vec3 middle, Real share) {
    if (share == 0) return camera;  // not even rounded
    const Real angle = 2 * pi * share;
    const Real c = std::cos(angle);
    const Real s = std::sin(angle);
    const auto turn = [=](Vec3 v) { return Vec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x); };
    camera.position = middle + turn(camera.position - middle);
    camera.direction = turn(camera.direction);
    return camera;
}

}  // namespace rt
