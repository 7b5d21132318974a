// origin: a student's: a cylinder without height taken for none
// caught by: small cylinders and short directions count: no epsilon on a or Δ (contract)
// sentence: You leave out flat cylinders: a height may be of any size.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    if (cylinder.height < Real(0.001) * cylinder.radius) return std::nullopt;
    return correct_intersect(ray, cylinder, interval);
}

}  // namespace rt
