// origin: CR §3.3: the counter counts blocked rays
// caught by: the share is that of the rays that reach the light, not of the blocked ones (CR §3.3)
// sentence: You return the share of the blocked rays: light and shadow are exchanged. Count those that reach the light, or take 1 minus it.
#define visibility(...) correct_lit_share(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility

namespace rt {

Real visibility(const ShadowRays& rays) {
    return 1 - correct_lit_share(rays);
}

}  // namespace rt
