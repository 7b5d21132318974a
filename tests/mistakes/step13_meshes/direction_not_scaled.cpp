// origin: invented: the scale divides the origin only
// caught by: a mesh twice as large: the ray and its direction are halved (HAI, scale)
// sentence: You divide the origin by the scale and forget the direction.
#define to_object_space(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef to_object_space

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    Ray seen = correct_into_frame(ray, placement);
    seen.direction *= placement.scale;
    return seen;
}

}  // namespace rt
