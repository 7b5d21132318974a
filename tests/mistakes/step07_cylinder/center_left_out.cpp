// origin: invented: ⟨p, Z⟩ for ⟨p − o, Z⟩
// caught by: the center is half-way: from -h/2 to h/2 (MRT §7)
// sentence: You forget the center: every coordinate in the cylinder's frame is of p − o.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    Cylinder at_origin = cylinder;
    at_origin.center = Vec3(0);
    return correct_intersect(ray, at_origin, interval);
}

}  // namespace rt
