// Lights instead of the torch.
#include "common/render/stage.hpp"

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
