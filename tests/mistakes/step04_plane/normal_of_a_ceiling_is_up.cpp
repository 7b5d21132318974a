// origin: invented: a horizontal plane is a floor
// caught by: the normal is the plane's, with unit length (PHY, situation A)
// sentence: The normal of a horizontal plane is always up in your answer. It is the plane's own: that of a ceiling may point down.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef normal

namespace rt {

Vec3 normal(const Plane& plane, Vec3 point) {
    const bool horizontal = plane.normal.x == 0 && plane.normal.z == 0;
    return horizontal ? Vec3(0, 1, 0) : correct_normal(plane, point);
}

}  // namespace rt
