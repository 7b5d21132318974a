// origin: a student's: an epsilon on ‖n‖
// caught by: the normal points to the side from which a, b, c are counterclockwise (MRT §5)
// sentence: You give small triangles another normal: (b − a) × (c − a) is short for them, and has its direction all the same.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef normal

namespace rt {

Vec3 normal(const Triangle& triangle, Vec3 /*point*/) {
    const Vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    return length(n) < Real(1e-7) ? Vec3(0, 0, 1) : n / length(n);
}

}  // namespace rt
