// origin: invented: the subject has a single light
// caught by: the light of two lights adds up (CR §3.1)
// sentence: You use the first light only. A scene may have several.
#include "common/math/vector.hpp"
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
    if (!scene.lights.empty()) {
        terms.diffuse = diffuse_term(surface, scene.lights.front());
        terms.specular = specular_term(surface, scene.lights.front());
    }
    return visible_sum(terms, context);
}

}  // namespace rt
