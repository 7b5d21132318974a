// origin: invented: stage 8 is kept
// caught by: ambient light alone is the color times its ratio, and no torch (CR §3.1)
// sentence: You still multiply by the torch of stage 3. The lights of the scene replace it.
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
    for (const Light& light : scene.lights) {
        terms.diffuse += diffuse_term(surface, light);
        terms.specular += specular_term(surface, light);
    }
    return torch(surface.point, surface.normal, ray.origin) * visible_sum(terms, context);
}

}  // namespace rt
