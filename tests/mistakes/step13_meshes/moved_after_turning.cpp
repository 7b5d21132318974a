// origin: invented: the inverses in the order of the motion
// caught by: a mesh is scaled, then turned, then moved, and the ray all that backwards (HAI)
// sentence: You rotate and scale the ray before you move it. The inverse starts with the last step: the translation.
#define to_object_space(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef to_object_space

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    const Basis& basis = placement.rotation;
    return {.origin = in_frame(basis, ray.origin) / placement.scale - placement.translation,
            .direction = in_frame(basis, ray.direction) / placement.scale};
}

}  // namespace rt
