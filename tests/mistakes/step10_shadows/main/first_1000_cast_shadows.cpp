// origin: invented: a limit of 1000
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
template <class List>
bool any_of(const List& list, const ShadowRay& way) {
    int n = 0;
    for (const auto& each : list)
        if (n++ < 1000)
            if (intersect(way.ray, each.shape, way.interval)) return true;
    return false;
}
bool dark(const Scene& scene, const ShadowRay& way) {
    return any_of(scene.spheres, way) || any_of(scene.planes, way) ||
           any_of(scene.triangles, way) || any_of(scene.squares, way) ||
           any_of(scene.cylinders, way) || any_of(scene.cones, way);
}
}  // namespace
Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const auto hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    const ShadingPoint s = shading_point(*hit, ray);
    PhongTerms sum;
    if (scene.ambient) sum.ambient = ambient_term(s, *scene.ambient);
    for (const Light& light : scene.lights) {
        ++context.rays;
        const ShadowRay way = shadow_ray(s, light.position);
        if (dark(scene, way)) continue;
        sum.diffuse += diffuse_term(s, light);
        sum.specular += specular_term(s, light);
    }
    return visible_sum(sum, context);
}
}  // namespace rt
