// origin: invented: shadows up to a number of reflections
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: You test no shadows after some reflections. What a mirror shows is in shadow as if it were seen.
#include "common/render/context.hpp"
#include "steps/step10_shadows/shadows.hpp"

namespace rt {

static ShadowRay until_three(ShadowRay way, const Context& context) {
    if (context.bounces > 2) way.interval.max = 0;
    return way;
}

}  // namespace rt

#define shadow_ray(surface, light) until_three(shadow_ray(surface, light), context)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
