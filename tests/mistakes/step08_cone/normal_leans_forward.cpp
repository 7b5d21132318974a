// origin: invented: the sign of the slope
// caught by: the normal leans back by the slope of the side (MRT §8)
// sentence: Your normal leans the wrong way: it points back towards the apex's end, −Z times the slope.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    const Vec3 from_apex = point - cone.apex;
    const Vec3 across = unit(from_apex - dot(from_apex, cone.axis) * cone.axis);
    return unit(cone.height * across + cone.radius * cone.axis);
}

}  // namespace rt
