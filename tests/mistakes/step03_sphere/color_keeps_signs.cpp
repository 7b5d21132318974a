// origin: invented: abs forgotten
// caught by: a normal's color is the size of its coordinates (M1)
// sentence: Your color keeps the signs of the normal: half of the sphere is black.
#define color_from_normal(...) correct_color_from_normal(__VA_ARGS__)
#include "steps/step03_sphere/reference/sphere.cpp"
#undef color_from_normal

namespace rt {

Color color_from_normal(Vec3 normal) {
    return unit(normal);
}

}  // namespace rt
