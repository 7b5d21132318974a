// origin: invented: the division by the radius forgotten
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: Your normal has the length of the radius. Divide by it, or make it a unit vector.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    return correct_normal(cylinder, point) * cylinder.radius;
}

}  // namespace rt
