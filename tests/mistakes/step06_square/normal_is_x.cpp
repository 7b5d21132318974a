// origin: invented: the wrong axis
// caught by: the normal is the square's Z (MRT §6)
// sentence: Your normal lies in the square. It is Z.
#define normal(...) correct_normal(__VA_ARGS__)
#include "steps/step06_square/reference/square.cpp"
#undef normal

namespace rt {

Vec3 normal(const Square& square, Vec3) {
    return square.basis.x;
}

}  // namespace rt
