// origin: invented: √(p / n)
// caught by: the error is the same for free and blocked rays exchanged (contract)
// sentence: Your error is largest if all rays are free, and smallest if all are blocked. It must be computed from p (1 − p).
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p / Real(rays.sent));
}

}  // namespace rt
