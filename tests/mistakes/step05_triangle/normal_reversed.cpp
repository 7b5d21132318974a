// origin: invented: the factors exchanged
// caught by: the normal points to the side from which a, b, c are counterclockwise (MRT §5)
// sentence: Your cross product has its factors exchanged: the normal points the other way.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef normal

namespace rt {

Vec3 normal(const Triangle& triangle, Vec3) {
    return unit(cross(triangle.c - triangle.a, triangle.b - triangle.a));
}

}  // namespace rt
