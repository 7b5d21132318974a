// origin: CR §4.1: areas as lengths
// caught by: beyond an edge the opposite corner's weight is negative (M1)
// sentence: Your areas have no sign: outside, the weights no longer give the point back.
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    return abs(correct_barycentric(triangle, point));
}

}  // namespace rt
