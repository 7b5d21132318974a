// right: the seed of the samples does not depend on the bounce; shadow rays hit meshes in their
// own frames
#include "common/math/vector.hpp"
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
bool dark(const Scene& scene, const ShadowRay& way, Context& context) {
    AnyHit any(way.ray, way.interval, context);
    visit_shapes(any, scene);
    if (any.found()) return true;
    for (const auto& box : scene.boxes)
        if (intersect(way.ray, box.shape, way.interval)) return true;
    for (const auto& mesh : scene.meshes) {
        const Ray local = to_object_space(way.ray, mesh.shape.placement);
        if (intersect(local, mesh.shape.model->mesh, way.interval)) return true;
    }
    return false;
}
Real share(const Scene& scene, const ShadingPoint& s, std::size_t i, Context& context) {
    const Light& light = scene.lights[i];
    if (!(light.radius > 0)) return dark(scene, shadow_ray(s, light.position), context) ? 0 : 1;
    const std::uint32_t seed = sample_seed(context.pixel, std::uint32_t(i) + 1, 0);
    ShadowRays rays;
    for (int k = 0; k < context.settings.shadow_samples; ++k) {
        const Vec3 aim = sample_light(light, s.point, spread_sample(std::uint32_t(k), seed));
        rays.sent++;
        if (!dark(scene, shadow_ray(s, aim), context)) rays.reached++;
    }
    return visibility(rays);
}
Color shaded(const Scene& scene, const ShadingPoint& s, Context& context) {
    PhongTerms sum;
    if (scene.ambient) sum.ambient = ambient_term(s, *scene.ambient);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Real w = share(scene, s, i, context);
        sum.diffuse += w * diffuse_term(s, light);
        sum.specular += w * specular_term(s, light);
    }
    return visible_sum(sum, context);
}
}  // namespace
Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    closest.test(scene.boxes);
    closest.test(scene.meshes);
    const auto hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    const ShadingPoint s = shading_point(*hit, ray);
    const Real k = s.material.mirror;
    const Color own = shaded(scene, s, context);
    if (k == 0) return own;
    Color seen(0);
    Context next = context;
    next.weight = context.weight * double(k);
    if (worth_reflecting(context.bounces, context.settings.depth, Real(next.weight))) {
        next.bounces = context.bounces + 1;
        seen = trace(scene, mirrored(ray, s), next);
        context.rays = next.rays;
    }
    return mixed(own, seen, k);
}
}  // namespace rt
