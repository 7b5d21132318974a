// right every_light_is_tried: a shadow ray for every light, and a helper that returns the light
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"

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
    for (const Light& light : scene.lights) {
        const ShadowRay way = shadow_ray(surface, light.position);
        if (!blocked(scene, way, context)) {
            terms.diffuse += diffuse_term(surface, light);
            terms.specular += specular_term(surface, light);
        }
    }
    return visible_sum(terms, context);
}

}  // namespace rt

// right without_a_log: the loop without the lines for --pixel
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"

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
    for (const Light& light : scene.lights) {
        const Color diffuse = diffuse_term(surface, light);
        const Color specular = specular_term(surface, light);
        if (diffuse + specular == Color(0)) continue;  // nothing that an occluder could remove
        if (blocked(scene, shadow_ray(surface, light.position), context)) continue;
        terms.diffuse += diffuse;
        terms.specular += specular;
    }
    return visible_sum(terms, context);
}

}  // namespace rt
