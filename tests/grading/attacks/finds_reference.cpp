// attack: declares the reference by another name, weakly
// ceiling: as a stub
// compiles: no
// message: Your file calls rt::correct_intersect(
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

[[gnu::weak]] std::optional<Real> correct_intersect(const Ray&, const Sphere&, Interval);

}  // namespace rt

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    if (&correct_intersect != nullptr) return correct_intersect(ray, sphere, interval);
    return std::nullopt;
}

}  // namespace rt
