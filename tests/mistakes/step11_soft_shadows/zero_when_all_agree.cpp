// origin: invented: √(p (1 − p) / n) with p unchanged
// caught by: the error is positive even if all rays agree (contract)
// sentence: If all rays agree your error is 0, and the sampling stops after the first few, whatever they overlooked. Count one more of each kind.
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached) / Real(rays.sent);
    return std::sqrt(p * (1 - p) / Real(rays.sent));
}

}  // namespace rt
