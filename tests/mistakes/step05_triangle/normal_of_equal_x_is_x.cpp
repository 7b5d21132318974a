// origin: invented: no product where the vertices have the same x
// caught by: the normal points to the side from which a, b, c are counterclockwise (MRT §5)
// sentence: If the three vertices have the same x, your normal is always (1, 0, 0). Its side depends on their order: (b − a) × (c − a).
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step05_triangle/reference/triangle.cpp"
#undef normal

namespace rt {

Vec3 normal(const Triangle& triangle, Vec3 point) {
    const auto& [a, b, c] = triangle;
    return a.x == b.x && b.x == c.x ? Vec3(1, 0, 0) : correct_normal(triangle, point);
}

}  // namespace rt
