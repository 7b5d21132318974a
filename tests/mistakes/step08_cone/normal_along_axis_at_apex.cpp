// origin: invented: the sign at the apex
// caught by: at the apex the normal is -axis (contract)
// sentence: At the apex your normal points into the cone. Outward is −axis, away from where it opens.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    if (point == cone.apex) return cone.axis;
    return correct_normal(cone, point);
}

}  // namespace rt
