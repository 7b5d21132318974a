// origin: invented: the normals of triangles and squares are not turned to the eye
// caught by: the surface is lit on the side of the eye (CR §3.1)
// sentence: You do not turn the normals of triangles and squares. They have two sides as well: shading_point turns every normal to the eye.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint turned_if_curved(const Hit& hit, const Ray& ray, const Scene& scene) {
    ShadingPoint surface = shading_point(hit, ray);
    const auto leave = [&](const auto& flat_shapes) {
        for (const auto& flat : flat_shapes)
            if (hit.material == &flat.material) surface.normal = hit.normal;
    };
    leave(scene.triangles);
    leave(scene.squares);
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) turned_if_curved(hit, ray, scene)
#include "tests/alternatives/step09_phong/main/without_a_log.cpp"
