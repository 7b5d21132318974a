// origin: invented: 0.999 for 1
// caught by: between vertices, the normal is between theirs, by the weights (CR §6)
// sentence: Near a vertex you return its normal. The normal is the weighted sum everywhere, and only at the vertex itself that of the vertex.
#define interpolated_normal(...) correct_interpolated_normal(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef interpolated_normal

namespace rt {

Vec3 interpolated_normal(const std::array<Vec3, 3>& normals, Vec3 weights) {
    for (int i = 0; i < 3; ++i)
        if (weights[i] > Real(0.999)) return normals[std::size_t(i)];
    return correct_interpolated_normal(normals, weights);
}

}  // namespace rt
