// Mirrors send rays on.
#include "common/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"

namespace rt {

namespace {

/// The colour along a ray that has been reflected `bounces` times and counts by `weight`.
Color color_along(const Scene& scene, const Ray& ray, int bounces, Real weight, Context& context) {
    Nearest nearest(ray, context);
    among_shapes(nearest, scene);
    const std::optional<Hit> hit = nearest.hit();
    if (!hit) return Color(0);
    if (context.look.shading == Shading::normal) return color_from_normal(hit->normal);

    const auto obstacles = [&](auto& query) { among_shapes(query, scene); };
    const Surface surface = surface_at(*hit, ray);
    const Real mirror = surface.material.mirror;
    context.weight = double(weight * (1 - mirror));
    const Terms terms =
        mirror < 1 ? lighting(scene, surface, bounces, obstacles, context) : Terms{};
    if (mirror == 0) return shown(terms, context);

    const Color own = mirror < 1 ? shown(terms, context) : Color(0);
    Color reflection(0);
    if (worth_reflecting(bounces, context.look.depth, weight * mirror))
        reflection =
            color_along(scene, mirrored(ray, surface), bounces + 1, weight * mirror, context);
    return mixed(own, reflection, mirror);
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    return color_along(scene, ray, 0, 1, context);
}

}  // namespace rt
