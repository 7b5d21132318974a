// origin: thought of: √(p / n)
// caught by: the error is the same for free and blocked rays exchanged (contract)
// sentence: Where all rays are free your error is largest, and where none is it is least. It is p (1 − p) that counts.
#define share_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef share_error

namespace rt {

Real share_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p / Real(rays.sent));
}

}  // namespace rt
