// Light and shadow, from here on.
#pragma once

#include "common/sampling.hpp"
#include "common/scene.hpp"
#include "common/shaft.hpp"
#include "common/story.hpp"
#include "common/surface.hpp"

#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include <algorithm>
#include <array>

namespace rt {

/// Whether the error of what the light adds to the pixel, a color times a share, is small enough,
/// or is taken to be nothing because all rays agree.
[[nodiscard]] bool accurate(const ShadowRays& rays, const Color& color, const Context& context);

// Each main.cpp knows what can stand in the way of a shadow ray: obstacles(query) has a Blocker, or
// another query, look through it. The functions that ask are templates, so that they are compiled
// into its `trace`, but for what only a light with a size needs: a scene whose lights have none
// then costs what it costs in stage 10 (tests/program/instruction_counts.sh).

/// Rays to a light with a size, which would add the given colour; none, if nothing can be in their
/// way. Has copies of the surface and the context, so that those of its caller stay in registers.
template <class Obstacles>
[[nodiscard, gnu::noinline]] ShadowRays rays_to(const Light& light, Surface surface, Color color,
                                                std::uint32_t seed, const Obstacles& obstacles,
                                                Context context) {
    const Shaft shaft(shadow_ray(surface, light.position).ray.origin, light);
    Suspects suspects(shaft);
    obstacles(suspects);
    ShadowRays rays;
    if (suspects.none()) {
        if (context.story != nullptr) context.story->remark("nothing can be in the light's way");
        return rays;
    }
    const Color seen = (1 - surface.material.mirror) * color;
    // A few ways ahead: a processor works out several at once, if nothing is asked in between.
    std::array<ShadowRay, 8> ways;
    while (rays.sent < context.look.shadow_samples && !accurate(rays, seen, context)) {
        const std::size_t next = std::size_t(rays.sent) % ways.size();
        for (std::size_t i = 0; next == 0 && i < ways.size(); ++i) {
            const Vec2 sample = spread_sample(std::uint32_t(std::size_t(rays.sent) + i), seed);
            ways[i] = shadow_ray(surface, light_point(light, surface.point, sample));
        }
        if (!suspects.block(ways[next].ray, ways[next].interval, context)) ++rays.reached;
        ++rays.sent;
    }
    if (context.story != nullptr)
        context.story->line("shadow rays that reach the light",
                            std::to_string(rays.reached) + " of " + std::to_string(rays.sent));
    return rays;
}

/// Whether nothing stands between the surface and a light without a size.
template <class Obstacles>
[[nodiscard]] bool reached(const Surface& surface, const Light& light, const Obstacles& obstacles,
                           Context& context) {
    const ShadowRay way = shadow_ray(surface, light.position);
    Blocker blocker(way.ray, way.interval, context);
    obstacles(blocker);
    return !blocker.found();
}

/// What all the lights do at the surface. A light with a size is asked for by several rays, until
/// --shadow-samples or --shadow-error is reached.
template <class Obstacles>
[[nodiscard]] Terms lighting(const Scene& scene, const Surface& surface, const Obstacles& obstacles,
                             Context& context) {
    Terms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    for (const Light& light : scene.lights) {
        if (context.story != nullptr) tell(*context.story, surface, light);
        const Color diffuse = diffuse_term(surface, light);
        const Color specular = specular_term(surface, light);
        if (diffuse + specular == Color(0)) continue;  // nothing to be kept off
        if (light.radius > 0) [[unlikely]] {
            const auto number = std::uint32_t(&light - scene.lights.data()) + 1;
            const std::uint32_t seed =
                sample_seed(context.pixel, number, std::uint32_t(context.bounces));
            const ShadowRays rays =
                rays_to(light, surface, diffuse + specular, seed, obstacles, context);
            const Real share = rays.sent == 0 ? 1 : lit_share(rays);
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
