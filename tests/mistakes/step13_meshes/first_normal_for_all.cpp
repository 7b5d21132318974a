// origin: course/mistakes.md: normals not interpolated
// caught by: between vertices, the normal is between theirs, by the weights (CR §6)
// sentence: You give the whole triangle one normal: its edges show. Take the three by their weights.
#define interpolated_normal(...) correct_interpolated_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef interpolated_normal

namespace rt {

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    return normals[0];
}

}  // namespace rt
