// origin: invented: o − p for p − o
// caught by: the normal leans back by the slope of the side (MRT §8)
// sentence: Your normal points into the cone. Outward is away from the axis.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step08_cone/reference/cone.cpp"
#undef normal

namespace rt {

Vec3 normal(const Cone& cone, Vec3 point) {
    return -correct_normal(cone, point);
}

}  // namespace rt
