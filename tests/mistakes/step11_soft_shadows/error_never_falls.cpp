// origin: invented: the division by the number of rays forgotten
// caught by: four times the rays halve the error at least, or nearly (contract)
// sentence: Your error does not fall as rays are added: no tolerance is ever reached. The standard deviation of one ray must be divided.
#define visibility_error(...) correct_share_error(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef visibility_error

namespace rt {

Real visibility_error(const ShadowRays& rays) {
    const Real p = Real(rays.reached + 1) / Real(rays.sent + 2);
    return std::sqrt(p * (1 - p));
}

}  // namespace rt
