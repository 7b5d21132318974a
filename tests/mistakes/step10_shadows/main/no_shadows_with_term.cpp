// origin: invented: --term is for the terms of stage 9
// caught by: ambient light reaches a shadow, and counts once (CR §3.2)
// sentence: With --term you test no shadows. A light that is hidden adds nothing to any term.
#include "common/render/context.hpp"
#include "steps/step10_shadows/shadows.hpp"

namespace rt {

static ShadowRay with_all_terms(ShadowRay way, const Context& context) {
    if (context.settings.term != PhongTerm::all) way.interval.max = 0;
    return way;
}

}  // namespace rt

#define shadow_ray(surface, light) with_all_terms(shadow_ray(surface, light), context)
#include "steps/step10_shadows/main.cpp"
