// origin: invented: the position taken for the base
// caught by: at z_p = h the radius is r: (r/h)², not r/h (erratum 4, MRT §8)
// sentence: You take the position for the base's center. It is the apex, and the cone widens along the axis.
#define intersect(...) correct_intersect(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef intersect

namespace rt {

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    Cone rotated = cone;
    rotated.apex = cone.apex + cone.height * cone.axis;
    rotated.axis = -cone.axis;
    return correct_intersect(ray, rotated, interval);
}

}  // namespace rt
