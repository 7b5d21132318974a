// origin: invented
// caught by: a shape of any color and material casts a shadow, on itself too (CR §3.2)
// sentence: You skip the shape that is seen: it casts no shadow on itself, but a tube does. The shadow ray already starts off the surface.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"

namespace rt {

static bool in_shadow(const Scene& scene, const ShadingPoint& surface, const Light& light,
                      Context& context) {
    const ShadowRay way = shadow_ray(surface, light.position);
    const auto test = [&](const auto& list) {
        for (const auto& each : list) {
            if (std::abs(distance_to_surface(surface.point, each.shape)) <= 10 * surface.error)
                continue;
            if (intersect(way.ray, each.shape, way.interval)) return true;
        }
        return false;
    };
    (void)context;
    return test(scene.spheres) || test(scene.planes) || test(scene.triangles) ||
           test(scene.squares) || test(scene.cylinders) || test(scene.cones);
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
    for (const Light& light : scene.lights) {
        if (in_shadow(scene, surface, light, context)) continue;
        terms.diffuse += diffuse_term(surface, light);
        terms.specular += specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
