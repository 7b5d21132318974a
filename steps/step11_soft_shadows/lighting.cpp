#include "steps/step11_soft_shadows/lighting.hpp"

#include <bit>

namespace rt {

namespace {

/// Before that, no estimate of an error is worth much.
constexpr int fewest_samples = 8;

}  // namespace

bool accurate(const ShadowRays& rays, const Color& color, const Look& look) {
    // Asked at powers of two, where the points are as even as they get.
    if (look.tolerance <= 0 || rays.sent < fewest_samples) return false;
    if (!std::has_single_bit(unsigned(rays.sent))) return false;
    const Real largest = glm::max(color.r, glm::max(color.g, color.b));
    return share_error(rays) * largest <= Real(look.tolerance);
}

}  // namespace rt
