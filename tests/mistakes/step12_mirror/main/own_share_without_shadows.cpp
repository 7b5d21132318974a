// origin: invented: a mirror shows no shadows
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: You test no shadows on a surface that is partly a mirror. Its own color is that of stage 11, with its shadows.
#include "steps/step10_shadows/shadows.hpp"

namespace rt {

static ShadowRay unless_a_mirror(ShadowRay way, const ShadingPoint& surface) {
    if (surface.material.mirror > 0) way.interval.max = 0;
    return way;
}

}  // namespace rt

#define shadow_ray(surface, light) unless_a_mirror(shadow_ray(surface, light), surface)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
