// origin: a student's: an epsilon before the division by the length
// caught by: a normal's color is the size of its coordinates (M1)
// sentence: You give short normals no color. The parameter of color_from_normal may have any length: make it a unit vector.
#define color_from_normal(...) correct_color_from_normal(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef color_from_normal

namespace rt {

Color color_from_normal(Vec3 normal) {
    return length(normal) < Real(1e-3) ? Color(0) : abs(normal) / length(normal);
}

}  // namespace rt
