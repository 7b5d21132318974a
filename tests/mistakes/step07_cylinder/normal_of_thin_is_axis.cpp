// origin: a student's: an epsilon on the distance from the axis
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: You give thin cylinders another normal: the way from the axis is short for them, and has its direction all the same.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 way = point - cylinder.center;
    const Vec3 across = way - dot(way, cylinder.axis) * cylinder.axis;
    return length(across) < Real(1e-4) ? cylinder.axis : unit(across);
}

}  // namespace rt
