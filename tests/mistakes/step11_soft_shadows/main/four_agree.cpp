// origin: invented: an end as soon as the first four samples agree
// caught by: a single sample is seen or not, and --shadow-samples is their number (CR §3.3)
// sentence: Samples are left out: trace spread_sample(i, seed) for each i from 0 to context.settings.shadow_samples − 1. If you stop once the first agree, or skip some, a light that is almost hidden, or almost free, loses its small share.
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
        if (rays.sent == 4 && (rays.reached == 0 || rays.reached == 4)) break;
    }
    return visibility(rays);
}

PhongTerms lit(const Scene& scene, const ShadingPoint& surface, Context& context) {
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    std::uint32_t number = 0;
    for (const Light& light : scene.lights) {
        const Real share = share_of(scene, surface, light, ++number, context);
        terms.diffuse += share * diffuse_term(surface, light);
        terms.specular += share * specular_term(surface, light);
    }
    return terms;
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    return visible_sum(lit(scene, surface, context), context);
}

}  // namespace rt
