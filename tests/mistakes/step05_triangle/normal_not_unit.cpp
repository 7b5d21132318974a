// origin: invented: (b − a) ∧ (c − a) as it is
// caught by: the normal points to the side from which a, b, c are counterclockwise (MRT §5)
// sentence: Your normal is as long as the parallelogram is large. Make it a unit vector.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef normal

namespace rt {

Vec3 normal(const Triangle& triangle, Vec3) {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

}  // namespace rt
