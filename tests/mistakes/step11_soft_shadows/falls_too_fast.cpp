// origin: invented: the error divided by n
// caught by: the estimate is honest: the true error is about as large, and no larger (contract)
// sentence: You divide by n: your error is less than the true one, and the sampling stops too soon. Even points gain n^(3/4), independent ones √n.
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p * (1 - p)) / Real(rays.sent);
}

}  // namespace rt
