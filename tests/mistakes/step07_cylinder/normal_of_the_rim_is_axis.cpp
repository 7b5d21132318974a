// origin: a student's: the normal of a cap
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: At the rims your normal is along the axis, as a cap's. There are no caps: a rim belongs to the side.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Real z = dot(point - cylinder.center, cylinder.axis);
    if (std::abs(z) > Real(0.4999) * cylinder.height) return z > 0 ? cylinder.axis : -cylinder.axis;
    return correct_normal(cylinder, point);
}

}  // namespace rt
