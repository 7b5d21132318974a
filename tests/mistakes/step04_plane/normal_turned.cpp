// origin: invented: the normal turned to the eye already here
// caught by: the normal is the plane's, with unit length (PHY, situation A)
// sentence: Your normal is reversed. It is the plane's, shading turns it.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef normal

namespace rt {

Vec3 normal(const Plane& plane, Vec3) {
    return unit(plane.normal.z < 0 ? -plane.normal : plane.normal);
}

}  // namespace rt
