// The lighting of a shading point, with shadows, from this stage on.
#pragma once

#include "common/explain/pixel_log.hpp"
#include "common/render/sampling.hpp"
#include "common/render/shaft.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <array>
#include <string>

namespace rt {

/// Returns whether the estimated error of the light's contribution to the pixel, color times
/// visible fraction, is small enough, or whether enough rays agree.
[[nodiscard]] bool accurate(const ShadowRays& rays, const Color& color, const Context& context);

}  // namespace rt

namespace rt {
inline namespace RT_PRECISION {

/// The points of a light that shadow rays aim at: spread_sample(first + i, seed).
struct LightPoints {
    std::uint32_t seed;
    std::uint32_t first;
};

/// The light's points for the rays of one shading point. The rays through a pixel share a sequence,
/// of which each uses a part of its own, so that together their points are as well spread as those
/// of one ray. `light` is the light's number, from 1.
[[nodiscard]] LightPoints light_points(const Context& context, std::uint32_t light);

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

// Each main.cpp defines the possible occluders: obstacles(query) tests an any-hit query, or another
// one, against them. The functions with queries are templates, so that they are compiled into
// `trace`, except for the part that only area lights need: a scene without area lights then costs
// the same as in stage 10 (tests/programs/instruction_counts.sh).

/// Traces shadow rays to an area light that would contribute the given color; none if the light has
/// no potential occluder. Takes copies of the shading point and the context, so that the caller's
/// remain in registers.
template <class Obstacles>
[[nodiscard, gnu::noinline]] ShadowRays rays_to(const Light& light, ShadingPoint surface,
                                                Color color, LightPoints points,
                                                const Obstacles& obstacles, Context context) {
    const Shaft shaft(shadow_ray(surface, light.position).ray.origin, light);
    PotentialOccluders occluders(shaft);
    obstacles(occluders);
    ShadowRays rays;
    if (occluders.none()) {
        if (context.log != nullptr) context.log->remark("no shape can occlude the light");
        return rays;
    }
    const Color seen = (1 - surface.material.mirror) * color;
    // Computed a few rays ahead: a processor computes several at once if no traversal is in
    // between.
    std::array<ShadowRay, 8> ways;
    while (rays.sent < context.settings.shadow_samples && !accurate(rays, seen, context)) {
        const std::size_t next = std::size_t(rays.sent) % ways.size();
        for (std::size_t i = 0; next == 0 && i < ways.size(); ++i) {
            const Vec2 sample = spread_sample(
                points.first + std::uint32_t(std::size_t(rays.sent) + i), points.seed);
            ways[i] = shadow_ray(surface, sample_light(light, surface.point, sample));
        }
        if (!occluders.block(ways[next].ray, ways[next].interval, context)) ++rays.reached;
        ++rays.sent;
    }
    if (context.log != nullptr)
        context.log->line("shadow rays that reach the light",
                          std::to_string(rays.reached) + " of " + std::to_string(rays.sent));
    return rays;
}

/// Returns whether the surface is visible from a point light.
template <class Obstacles>
[[nodiscard]] bool reached(const ShadingPoint& surface, const Light& light,
                           const Obstacles& obstacles, Context& context) {
    const ShadowRay way = shadow_ray(surface, light.position);
    AnyHit any_hit(way.ray, way.interval, context);
    obstacles(any_hit);
    return !any_hit.found();
}

/// The terms of all lights at the shading point. An area light is sampled with several rays, until
/// the limit of --shadow-samples or --shadow-error.
template <class Obstacles>
[[nodiscard]] PhongTerms lighting(const Scene& scene, const ShadingPoint& surface,
                                  const Obstacles& obstacles, Context& context) {
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    for (const Light& light : scene.lights) {
        if (context.log != nullptr) explain(*context.log, surface, light);
        const Color diffuse = diffuse_term(surface, light);
        const Color specular = specular_term(surface, light);
        if (diffuse + specular == Color(0)) continue;  // nothing that an occluder could remove
        if (light.radius > 0) [[unlikely]] {
            const auto number = std::uint32_t(&light - scene.lights.data()) + 1;
            const LightPoints points = light_points(context, number);
            const ShadowRays rays =
                rays_to(light, surface, diffuse + specular, points, obstacles, context);
            const Real share = rays.sent == 0 ? 1 : visibility(rays);
            context.rays += rays.sent;
            context.sized_light_rays += rays.sent;
            terms.diffuse += share * diffuse;
            terms.specular += share * specular;
        } else if (reached(surface, light, obstacles, context)) {
            terms.diffuse += diffuse;
            terms.specular += specular;
        }
    }
    return terms;
}

}  // namespace rt
