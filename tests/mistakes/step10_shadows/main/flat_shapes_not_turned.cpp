// origin: invented: the normals of flat shapes are not turned to the eye
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: You turn the normals of curved shapes only, as if flat ones had one side. shading_point turns every normal to the eye.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint turned_if_curved(const Hit& hit, const Ray& ray, const Scene& scene) {
    ShadingPoint surface = shading_point(hit, ray);
    const auto leave = [&](const auto& flat_shapes) {
        for (const auto& flat : flat_shapes)
            if (hit.material == &flat.material) surface.normal = hit.normal;
    };
    leave(scene.planes);
    leave(scene.triangles);
    leave(scene.squares);
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) turned_if_curved(hit, ray, scene)
#include "tests/alternatives/step10_shadows/main/without_a_log.cpp"
