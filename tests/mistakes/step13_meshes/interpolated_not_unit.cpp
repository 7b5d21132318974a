// origin: course/mistakes.md
// caught by: an interpolated normal has unit length (CR §6)
// sentence: Between three unit normals the sum is shorter than 1. Make it unit length, or the triangle's middle is too dark.
#define interpolated_normal(...) correct_interpolated_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef interpolated_normal

namespace rt {

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    return weights.x * normals[0] + weights.y * normals[1] + weights.z * normals[2];
}

}  // namespace rt
