// origin: invented: shading_point is not used
// caught by: the surface is lit on the side of the eye (CR §3.1)
// sentence: You light the side that the normal points to. shading_point turns it to the eye.
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

    ShadingPoint surface = shading_point(*hit, ray);
    surface.normal = hit->normal;
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    for (const Light& light : scene.lights) {
        terms.diffuse += diffuse_term(surface, light);
        terms.specular += specular_term(surface, light);
    }
    return visible_sum(terms, context);
}

}  // namespace rt
