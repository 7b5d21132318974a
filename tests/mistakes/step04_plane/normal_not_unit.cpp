// origin: PHY works with n, and the scene has N
// caught by: the normal is the plane's, with unit length (PHY, situation A)
// sentence: Your normal is as long as the scene's. Make it a unit vector.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef normal

namespace rt {

Vec3 normal(const Plane& plane, Vec3) {
    return plane.normal;
}

}  // namespace rt
