#include "steps/step11_soft_shadows/lighting.hpp"

#include "common/system/hash.hpp"

#include <bit>

namespace rt {

namespace {

/// With fewer samples, the estimate of the error is not reliable.
constexpr int fewest_samples = 8;

}  // namespace

bool accurate(const ShadowRays& rays, const Color& color, const Context& context) {
    const RenderSettings& settings = context.settings;
    if (settings.shadow_error <= 0) return false;
    const bool agree = rays.reached == 0 || rays.reached == rays.sent;
    if (agree && settings.shadow_agree > 0 && rays.sent >= settings.shadow_agree) return true;
    // Evaluated at powers of two, where the points are best spread.
    if (rays.sent < fewest_samples || !std::has_single_bit(unsigned(rays.sent))) return false;
    const Real largest = glm::max(color.r, glm::max(color.g, color.b));
    const Real steps = 255 * visibility_error(rays) * largest * Real(context.weight);
    return steps <= Real(settings.shadow_error);
}

LightPoints RT_PRECISION::light_points(const Context& context, std::uint32_t light) {
    const auto bounces = std::uint32_t(context.bounces);
    if (context.sample < 0) return {.seed = sample_seed(context.pixel, light, bounces), .first = 0};
    const std::uint32_t seed = sample_seed(context.whole_pixel, light, bounces);
    const std::uint32_t part = shuffled(std::uint32_t(context.sample), mixed_bits(seed));
    return {.seed = seed, .first = part * std::uint32_t(context.settings.shadow_samples)};
}

}  // namespace rt
