// origin: M1, erratum 7
// caught by: a corner's own weight is 1 there (erratum 7, M1)
// sentence: You take the area beside a corner for its weight. The weight of a is the area opposite to it.
#define barycentric(...) correct_barycentric(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef barycentric

namespace rt {

Vec3 barycentric(const Triangle& triangle, Vec3 point) {
    const Vec3 w = correct_barycentric(triangle, point);
    return {w.y, w.x, w.z};
}

}  // namespace rt
