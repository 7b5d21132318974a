// origin: a student's: the normal of a base
// caught by: the normal leans back by the slope of the side (MRT §8)
// sentence: At the rim your normal is along the axis, as a base's. The cone has no base: the rim belongs to the side.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    if (dot(point - cone.apex, cone.axis) > Real(0.9999) * cone.height) return cone.axis;
    return correct_normal(cone, point);
}

}  // namespace rt
