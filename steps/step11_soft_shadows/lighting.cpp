#include "steps/step11_soft_shadows/lighting.hpp"

#include "common/sampling.hpp"
#include "common/story.hpp"

#include "steps/step09_phong/phong.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <bit>

namespace rt {

namespace {

/// Before that, no estimate of an error is worth much.
constexpr int fewest_samples = 8;

/// Whether the error of what the light adds to the pixel, a color times a share, is small enough.
/// Asked at powers of two, where the points are as even as they get.
bool accurate(const ShadowRays& rays, const Color& color, const Look& look) {
    if (look.tolerance <= 0 || rays.sent < fewest_samples) return false;
    if (!std::has_single_bit(unsigned(rays.sent))) return false;
    const Real largest = glm::max(color.r, glm::max(color.g, color.b));
    return share_error(rays) * largest <= Real(look.tolerance);
}

/// The share of the light that reaches the surface, where it would add the given colour.
Real share_reached(const Scene& scene, const Surface& surface, const Light& light,
                   const Color& color, std::uint32_t seed, Context& context) {
    ShadowRays rays;
    while (rays.sent < context.look.shadow_samples && !accurate(rays, color, context.look)) {
        const Vec2 sample = spread_sample(std::uint32_t(rays.sent), seed);
        const Vec3 aim = light_point(light, surface.point, sample);
        if (!blocked(scene, shadow_ray(surface, aim), context)) ++rays.reached;
        ++rays.sent;
    }
    context.sized_light_rays += rays.sent;
    if (context.story != nullptr)
        context.story->line("shadow rays that reach the light",
                            std::to_string(rays.reached) + " of " + std::to_string(rays.sent));
    return lit_share(rays);
}

}  // namespace

Terms lighting(const Scene& scene, const Surface& surface, std::uint32_t bounce, Context& context) {
    Terms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    std::uint32_t number = 0;
    for (const Light& light : scene.lights) {
        ++number;
        if (context.story != nullptr) tell(*context.story, surface, light);
        const Color diffuse = diffuse_term(surface, light);
        const Color specular = specular_term(surface, light);
        if (diffuse + specular == Color(0)) continue;  // nothing to be kept off
        if (light.radius > 0) {
            const std::uint32_t seed = sample_seed(context.pixel, number, bounce);
            const Real share =
                share_reached(scene, surface, light, diffuse + specular, seed, context);
            terms.diffuse += share * diffuse;
            terms.specular += share * specular;
        } else if (!blocked(scene, shadow_ray(surface, light.position), context)) {
            terms.diffuse += diffuse;
            terms.specular += specular;
        }
    }
    return terms;
}

}  // namespace rt
