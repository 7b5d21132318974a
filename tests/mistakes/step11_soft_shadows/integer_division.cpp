// origin: invented: int / int
// caught by: the share is that of the rays that reach the light, not of the blocked ones (CR §3.3)
// sentence: You divide whole numbers: 3 / 4 is 0, and only what sees all of the light is lit. Make them Real first.
#define visibility(...) correct_lit_share(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility

namespace rt {

Real visibility(const ShadowRays& rays) {
    return Real(rays.reached / rays.sent);
}

}  // namespace rt
