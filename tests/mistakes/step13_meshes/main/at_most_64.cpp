// origin: invented: at most 64 samples, whatever the option is
// caught by: every kind of shape casts a shadow, up to both ends of its way (CR §3.2)
// sentence: You trace a fixed number of samples at most. context.settings.shadow_samples is their number.
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

namespace {

bool blocked(const Scene& scene, const ShadowRay& way, Context& context) {
    AnyHit any_hit(way.ray, way.interval, context);
    visit_shapes(any_hit, scene);
    any_hit.test(scene.boxes);
    any_hit.test(scene.meshes);
    return any_hit.found();
}

Real share_of(const Scene& scene, const ShadingPoint& surface, const Light& light,
              std::uint32_t number, Context& context) {
    if (light.radius == 0)
        return blocked(scene, shadow_ray(surface, light.position), context) ? 0 : 1;
    const std::uint32_t seed = sample_seed(context.pixel, number, std::uint32_t(context.bounces));
    ShadowRays rays;
    const int count = context.settings.shadow_samples < 64 ? context.settings.shadow_samples : 64;
    for (int i = 0; i < count; ++i) {
        const Vec2 sample = spread_sample(std::uint32_t(i), seed);
        const Vec3 aim = sample_light(light, surface.point, sample);
        if (!blocked(scene, shadow_ray(surface, aim), context)) ++rays.reached;
        ++rays.sent;
    }
    return visibility(rays);
}

PhongTerms lit(const Scene& scene, const ShadingPoint& surface, Context& context) {
    PhongTerms terms;
    if (scene.ambient) terms.ambient = ambient_term(surface, *scene.ambient);
    std::uint32_t number = 0;
    for (const Light& light : scene.lights) {
        const Real share = share_of(scene, surface, light, ++number, context);
        terms.diffuse += share * diffuse_term(surface, light);
        terms.specular += share * specular_term(surface, light);
    }
    return terms;
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    closest.test(scene.boxes);
    closest.test(scene.meshes);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const Color own = visible_sum(lit(scene, surface, context), context);
    if (mirror == 0) return own;
    Color seen(0);
    const double weight = context.weight * double(mirror);
    if (worth_reflecting(context.bounces, context.settings.depth, Real(weight))) {
        Context there = context;
        there.bounces = context.bounces + 1;
        there.weight = weight;
        seen = trace(scene, mirrored(ray, surface), there);
        context.rays = there.rays;
    }
    return mixed(own, seen, mirror);
}

}  // namespace rt
