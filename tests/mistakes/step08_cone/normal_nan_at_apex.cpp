// origin: invented: 0 / 0
// caught by: at the apex the normal is -axis (contract)
// sentence: At the apex nothing is left across the axis, and 0 / 0 is NaN. Every direction would do there: take −axis.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    const Vec3 from_apex = point - cone.apex;
    const Vec3 across = unit(from_apex - dot(from_apex, cone.axis) * cone.axis);
    return unit(cone.height * across - cone.radius * cone.axis);
}

}  // namespace rt
