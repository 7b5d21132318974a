// origin: invented: the division by the radius forgotten
// caught by: the normal points away from the center, with unit length (M1)
// sentence: Your normal has the length of the radius. Divide by it, or make it a unit vector.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef normal

namespace rt {

Vec3 normal(const Sphere& sphere, Vec3 point) {
    return point - sphere.center;
}

}  // namespace rt
