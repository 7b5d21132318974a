// origin: invented: the sphere's normal
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: Your normal points away from the center, as a sphere's does. Take its part along the axis away.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    return unit(point - cylinder.center);
}

}  // namespace rt
