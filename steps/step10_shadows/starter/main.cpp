// Your trace of stage 10 (CR §3.2). This stage adds shadows: a light counts only if no shape is in
// the way of shadow_ray(surface, light.position), of "steps/step10_shadows/shadows.hpp".
//
// AnyHit, of common/render/closest_hit.hpp, finds out whether any shape is hit inside an interval:
//     AnyHit any_hit(way.ray, way.interval, context);
//     visit_shapes(any_hit, scene);
// and then any_hit.found().
#include "common/render/stage.hpp"

#include "common/math/vector.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"

namespace rt {

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
        if (context.log != nullptr) explain(*context.log, surface, light);
        terms.diffuse += diffuse_term(surface, light);
        terms.specular += specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
