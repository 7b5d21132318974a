// right colors_of_samples: the terms are added for each sample that reaches the light
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

namespace rt {

namespace {

bool blocked(const Scene& scene, const ShadowRay& way, Context& context) {
    AnyHit any_hit(way.ray, way.interval, context);
    visit_shapes(any_hit, scene);
    return any_hit.found();
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    std::uint32_t number = 0;
    for (const Light& light : scene.lights) {
        const int samples = light.radius > 0 ? context.settings.shadow_samples : 1;
        const std::uint32_t seed = sample_seed(context.pixel, ++number, 0);
        for (int i = 0; i < samples; ++i) {
            const Vec3 aim =
                sample_light(light, surface.point, spread_sample(std::uint32_t(i), seed));
            if (blocked(scene, shadow_ray(surface, aim), context)) continue;
            terms.diffuse += diffuse_term(surface, light) / Real(samples);
            terms.specular += specular_term(surface, light) / Real(samples);
        }
    }
    return visible_sum(terms, context);
}

}  // namespace rt

// right plain_loop: every sample, without a hierarchy of occluders
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

namespace rt {

namespace {

bool blocked(const Scene& scene, const ShadowRay& way, Context& context) {
    AnyHit any_hit(way.ray, way.interval, context);
    visit_shapes(any_hit, scene);
    return any_hit.found();
}

Real share_of(const Scene& scene, const ShadingPoint& surface, const Light& light,
              std::uint32_t number, Context& context) {
    if (light.radius == 0)
        return blocked(scene, shadow_ray(surface, light.position), context) ? 0 : 1;
    const std::uint32_t seed = sample_seed(context.pixel, number, std::uint32_t(context.bounces));
    ShadowRays rays;
    for (int i = 0; i < context.settings.shadow_samples; ++i) {
        const Vec2 sample = spread_sample(std::uint32_t(i), seed);
        const Vec3 aim = sample_light(light, surface.point, sample);
        if (!blocked(scene, shadow_ray(surface, aim), context)) ++rays.reached;
        ++rays.sent;
    }
    return visibility(rays);
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    std::uint32_t number = 0;
    for (const Light& light : scene.lights) {
        const Real share = share_of(scene, surface, light, ++number, context);
        terms.diffuse += share * diffuse_term(surface, light);
        terms.specular += share * specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
