// origin: course/mistakes.md
// caught by: t compares with other shapes': the nearest of a mesh and a ball is seen (M1)
// sentence: You make the direction unit length in the mesh's frame: t then counts in other units there, and no longer compares with the other shapes'.
#define to_object_space(...) correct_into_frame(__VA_ARGS__)
#include "steps/step13_meshes/reference/meshes.cpp"
#undef to_object_space

namespace rt {

Ray to_object_space(const Ray& ray, const Transform& placement) {
    Ray seen = correct_into_frame(ray, placement);
    seen.direction = unit(seen.direction);
    return seen;
}

}  // namespace rt
