// origin: invented: o − p for p − o
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: Your normal points to the axis. Outward is away from it.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    return -correct_normal(cylinder, point);
}

}  // namespace rt
