// origin: invented: a square across z has the axis as normal
// caught by: the normal is the square's Z (MRT §6)
// sentence: The normal of a square across the z axis is always (0, 0, 1) in your answer. It is basis.z, which may be (0, 0, -1).
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef normal

namespace rt {

Vec3 normal(const Square& square, Vec3 point) {
    const Vec3 z = correct_normal(square, point);
    return z.x == 0 && z.y == 0 ? Vec3(0, 0, 1) : z;
}

}  // namespace rt
