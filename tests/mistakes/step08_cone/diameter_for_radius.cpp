// origin: invented: the scene's diameter not halved
// caught by: at z_p = h the radius is r: (r/h)², not r/h (erratum 4, MRT §8)
// sentence: Your cone is twice as wide: r is the radius.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    Cone wide = cone;
    wide.radius *= 2;
    return correct_intersect(ray, wide, interval);
}

}  // namespace rt
