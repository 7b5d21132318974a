// right boxes_and_meshes_apart: a function for all lists
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step12_mirror/reflection.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

namespace {

template <class Query>
void test_all(Query& query, const Scene& scene) {
    visit_shapes(query, scene);
    query.test(scene.boxes);
    query.test(scene.meshes);
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    const auto everything = [&scene](auto& query) { test_all(query, scene); };
    ClosestHit closest(ray, context);
    test_all(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const PhongTerms terms =
        mirror < 1 ? lighting(scene, surface, everything, context) : PhongTerms{};
    if (mirror == 0) return visible_sum(terms, context);

    const Color own = mirror < 1 ? visible_sum(terms, context) : Color(0);
    return mixed(own, reflection(scene, ray, surface, context), mirror);
}

}  // namespace rt

// right own_samples: the samples and the recursion are written here
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
    for (int i = 0; i < context.settings.shadow_samples; ++i) {
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

// right seed_without_bounce: the seed of the samples does not depend on the bounce; shadow rays hit
// meshes in their own frames
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

// right two_lambdas: other names, and the lists in another order
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step12_mirror/reflection.hpp"
#include "steps/step13_meshes/mesh_instance.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    const auto everything = [&](auto& query) {
        query.test(scene.meshes);
        query.test(scene.boxes);
        visit_shapes(query, scene);
    };
    ClosestHit closest(ray, context);
    everything(closest);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const PhongTerms terms =
        mirror < 1 ? lighting(scene, surface, everything, context) : PhongTerms{};
    if (mirror == 0) return visible_sum(terms, context);

    const Color own = mirror < 1 ? visible_sum(terms, context) : Color(0);
    return mixed(own, reflection(scene, ray, surface, context), mirror);
}

}  // namespace rt
