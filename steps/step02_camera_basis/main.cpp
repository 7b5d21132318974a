// The camera in any direction; the sky has lines of latitude and longitude that show it.
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// Returns whether the angle is within a quarter of a degree of a grid line, one every 15 degrees.
bool on_line(Real angle) {
    constexpr Real degree = pi / 180;
    return std::abs(std::remainder(angle, 15 * degree)) < degree / 4;
}

}  // namespace

Color trace(const Scene& /*scene*/, const Ray& ray, Context& context) {
    ++context.rays;
    const Vec3 d = unit(ray.direction);
    const Real latitude = std::asin(glm::clamp(d.y, Real(-1), Real(1)));
    const Real longitude = std::atan2(d.x, -d.z);
    const Color sky = (d + Real(1)) / Real(2);
    return on_line(latitude) || on_line(longitude) ? sky / Real(2) : sky;
}

}  // namespace rt
