// origin: invented: the scene's diameter not halved
// caught by: a ray across meets the near side (MRT §7)
// sentence: Your cylinder is twice as thick: r is the radius.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    Cylinder thick = cylinder;
    thick.radius *= 2;
    return correct_intersect(ray, thick, interval);
}

}  // namespace rt
