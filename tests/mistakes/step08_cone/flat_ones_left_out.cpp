// origin: a student's: a cone without height taken for none
// caught by: small cones and short directions count: no epsilon on a or Δ (contract)
// sentence: You leave out flat cones: the height and the radius may be of any size.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    if (cone.height < Real(0.01) * cone.radius) return std::nullopt;
    return correct_intersect(ray, cone, interval);
}

}  // namespace rt
