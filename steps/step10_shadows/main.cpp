// Shadows: an occluded light contributes nothing.
#include "common/math/vector.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"

namespace rt {

namespace {

bool blocked(const Scene& scene, const ShadowRay& way, Context& context) {
    Blocker blocker(way.ray, way.interval, context);
    among_shapes(blocker, scene);
    return blocker.found();
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    Nearest nearest(ray, context);
    among_shapes(nearest, scene);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);

    const Surface surface = surface_at(*hit, ray);
    Terms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    for (const Light& light : scene.lights) {
        if (context.story != nullptr) tell(*context.story, surface, light);
        const Color diffuse = diffuse_term(surface, light);
        const Color specular = specular_term(surface, light);
        if (diffuse + specular == Color(0)) continue;  // nothing that an occluder could remove
        if (blocked(scene, shadow_ray(surface, light.position), context)) continue;
        terms.diffuse += diffuse;
        terms.specular += specular;
    }
    return shown(terms, context);
}

}  // namespace rt
