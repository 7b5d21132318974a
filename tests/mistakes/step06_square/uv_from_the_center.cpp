// origin: invented: the center for the corner
// caught by: u and v are 0 at the corner C and 1 at the ends of its edges (erratum 10, HAI)
// sentence: Your u and v are 0 in the middle. They are measured from the corner C.
#define square_uv(...) correct_square_uv(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef square_uv

namespace rt {

Vec2 square_uv(const Square& square, Vec3 point) {
    return correct_square_uv(square, point) - Real(0.5);
}

}  // namespace rt
