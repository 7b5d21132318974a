// origin: invented: o − p where p − o is meant
// caught by: the normal points away from the center, with unit length (M1)
// sentence: Your normal points to the center. It is p − o, from the center to the point.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef normal

namespace rt {

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return unit(sphere.center - point);
}

}  // namespace rt
