// origin: invented: the variance for its root
// caught by: the estimate is honest: the true error is about as large, and no larger (contract)
// sentence: You return a variance. Its square root is the error.
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return p * (1 - p) / Real(rays.sent);
}

}  // namespace rt
