// origin: invented: the scale divides the origin only
// caught by: a mesh twice as large: the ray and its direction are halved (HAI, scale)
// sentence: You divide the origin by the scale and forget the direction.
#define into_frame(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef into_frame

namespace rt {

Ray into_frame(const Ray& ray, const Motion& placement) {
    Ray seen = correct_into_frame(ray, placement);
    seen.direction *= placement.scale;
    return seen;
}

}  // namespace rt
