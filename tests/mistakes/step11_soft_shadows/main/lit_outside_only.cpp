// origin: invented: shading_point is not used
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: You light the side that the normal points to. shading_point turns it to the eye.
#include "common/render/closest_hit.hpp"

namespace rt {

static ShadingPoint not_turned(const Hit& hit, const Ray& ray) {
    ShadingPoint surface = shading_point(hit, ray);
    surface.normal = hit.normal;
    return surface;
}

}  // namespace rt

#define shading_point(hit, ray) not_turned(hit, ray)
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
