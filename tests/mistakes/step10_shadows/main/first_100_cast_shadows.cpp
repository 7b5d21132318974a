// origin: invented: an array of 100 objects, as in C
// caught by: every kind of shape casts a shadow (CR §3.2)
// sentence: You test a fixed number of shapes of a list in the way of the light. A scene may have any number.
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
    const auto test = [&any_hit](const auto& list) {
        std::remove_cvref_t<decltype(list)> first;
        for (std::size_t i = 0; i < list.size() && i < 100; ++i) first.push_back(list[i]);
        any_hit.test(first);
    };
    test(scene.spheres);
    test(scene.planes);
    test(scene.triangles);
    test(scene.squares);
    test(scene.cylinders);
    test(scene.cones);
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
        if (blocked(scene, shadow_ray(surface, light.position), context)) continue;
        terms.diffuse += diffuse_term(surface, light);
        terms.specular += specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
