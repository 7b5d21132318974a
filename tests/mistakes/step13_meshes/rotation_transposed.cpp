// origin: invented: the matrix in place of its inverse
// caught by: a mesh that is turned: the ray is turned the other way (HAI, rotate)
// sentence: You turn the ray as the mesh is turned. It must be turned the other way: by the products with x, y and z.
#define to_object_space(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef to_object_space

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const auto wrong = [&placement](Vec3 v) { return rotated(v, placement) / placement.scale; };
    return {.origin = wrong(ray.origin - placement.translation), .direction = wrong(ray.direction)};
}

}  // namespace rt
