// origin: seen in student repositories: y for the axis
// caught by: the normal points away from the axis, with unit length (MRT §7)
// sentence: Your normal leaves y out, whatever the axis. Take ⟨p − o, Z⟩ Z away.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step07_cylinder/reference/cylinder.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cylinder& cylinder, Vec3 point) {
    const Vec3 p = point - cylinder.center;
    return unit(Vec3(p.x, 0, p.z));
}

}  // namespace rt
