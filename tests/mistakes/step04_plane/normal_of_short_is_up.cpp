// origin: a student's: an epsilon before the division by the length
// caught by: the normal is the plane's, with unit length (PHY, situation A)
// sentence: You take a short normal for none. It may have any length but 0.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step04_plane/reference/plane.cpp"
#undef normal

namespace rt {

Vec3 normal(const Plane& plane, Vec3 /*point*/) {
    return length(plane.normal) < Real(1e-6) ? Vec3(0, 1, 0) : plane.normal / length(plane.normal);
}

}  // namespace rt
