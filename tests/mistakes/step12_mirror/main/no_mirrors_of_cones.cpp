// origin: invented: the last list of shapes is left out
// caught by: each kind of shape is a mirror, from either side (CR §5.1)
// sentence: Your cones reflect nothing. A mirror is a material, and a shape of any kind may have it.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint without_mirrors_of_cones(const Hit& hit, const Ray& ray, const Scene& scene) {
    ShadingPoint surface = shading_point(hit, ray);
    for (const Primitive<Cone>& cone : scene.cones)
        if (hit.material == &cone.material) surface.material.mirror = 0;
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) without_mirrors_of_cones(hit, ray, scene)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
