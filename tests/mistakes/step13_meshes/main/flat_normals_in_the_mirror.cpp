// origin: invented
// caught by: a mesh is lit by its interpolated normals (CR §4.1.2)
// sentence: In the mirror you light a mesh by the normal of the flat face. It is lit by its interpolated normal there too: surface.normal.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint flat_after_a_mirror(ShadingPoint surface, const Context& context) {
    if (context.bounces > 0) surface.normal = surface.geometric_normal;
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) flat_after_a_mirror(shading_point(hit, ray), context)
#include "tests/alternatives/step13_meshes/main/own_samples.cpp"
