// attack: throws an exception with a message of 40 MB
// ceiling: as a stub
// told: threw an exception: <<<
#include "steps/step03_sphere/sphere.hpp"

#include <stdexcept>
#include <string>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    throw std::runtime_error(std::string(40000000, '<'));
}

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
