// origin: seen in student repositories
// caught by: the normal leans back by the slope of the side (MRT §8)
// sentence: Your normal points straight away from the axis, as a cylinder's does. The side leans: so does its normal.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    const Vec3 from_apex = point - cone.apex;
    return unit(from_apex - dot(from_apex, cone.axis) * cone.axis);
}

}  // namespace rt
