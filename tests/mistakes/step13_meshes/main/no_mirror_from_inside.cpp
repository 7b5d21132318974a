// origin: invented
// caught by: boxes and meshes are seen in a mirror, and are mirrors (CR §5.1)
// sentence: A mirror reflects on both sides: from inside a box too.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint without_mirrors_inside(const Hit& hit, const Ray& ray) {
    ShadingPoint surface = shading_point(hit, ray);
    if (dot(hit.normal, ray.direction) > 0) surface.material.mirror = 0;
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) without_mirrors_inside(hit, ray)
#include "tests/alternatives/step13_meshes/main/own_samples.cpp"
