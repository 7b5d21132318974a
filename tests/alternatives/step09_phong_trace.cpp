// right sum_of_colors: one sum, and --term by hand
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
    const PhongTerm term = context.settings.term;
    const auto wanted = [term](PhongTerm each) { return term == PhongTerm::all || term == each; };
    Color sum(0);
    if (scene.ambient && wanted(PhongTerm::ambient)) sum += ambient_term(surface, *scene.ambient);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (wanted(PhongTerm::diffuse)) sum += diffuse_term(surface, scene.lights[i]);
        if (wanted(PhongTerm::specular)) sum += specular_term(surface, scene.lights[i]);
    }
    return sum;
}

}  // namespace rt

// right without_a_log: the loop without the lines for --pixel
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
    return visible_sum(terms, context);
}

}  // namespace rt
