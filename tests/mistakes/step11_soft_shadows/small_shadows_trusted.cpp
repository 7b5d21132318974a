// origin: invented: √(p (1 − p)) / n^(3/4), as of independent points
// caught by: it is honest too where little of the light is hidden (contract)
// sentence: Where little of the light is hidden your error is less than the true one: the edge of a share p is about √p long, and the error goes with p^(1/4), not with √p.
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p * (1 - p)) / std::pow(Real(rays.sent), Real(0.75));
}

}  // namespace rt
