// origin: a student's: an epsilon on the distance from the axis
// caught by: near the apex, the normal leans as everywhere (contract)
// sentence: You take a point near the apex for the apex: only at the apex itself the normal is −axis.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    const Vec3 way = point - cone.apex;
    const Vec3 across = way - dot(way, cone.axis) * cone.axis;
    return length(across) < Real(0.001) * cone.radius ? -cone.axis : correct_normal(cone, point);
}

}  // namespace rt
