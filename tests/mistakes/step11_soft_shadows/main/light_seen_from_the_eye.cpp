// origin: invented
// caught by: half of an area light gives half of its light (CR §3.3)
// sentence: sample_light receives the eye. It takes the point that is lit, surface.point.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

namespace rt {

static bool in_shadow(const Scene& scene, const ShadowRay& way, Context& context) {
    AnyHit any(way.ray, way.interval, context);
    visit_shapes(any, scene);
    return any.found();
}

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
        ++number;
        ShadowRays rays;
        const int samples = light.radius > 0 ? context.settings.shadow_samples : 1;
        const std::uint32_t seed =
            sample_seed(context.pixel, number, std::uint32_t(context.bounces));
        for (int i = 0; i < samples; ++i) {
            const Vec2 sample = spread_sample(std::uint32_t(i), seed);
            const Vec3 aim = sample_light(light, ray.origin, sample);
            ++rays.sent;
            if (!in_shadow(scene, shadow_ray(surface, aim), context)) ++rays.reached;
        }
        const Real share = visibility(rays);
        terms.diffuse += share * diffuse_term(surface, light);
        terms.specular += share * specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
