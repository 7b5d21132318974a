// origin: a student's: asked before the share is multiplied
// caught by: a reflection of a weight below 1/512 is black, however many mirrors made it (contract)
// sentence: You ask worth_reflecting with the weight of the ray that arrives. Multiply it by this mirror's share first: that is the weight of the reflection.
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"

namespace rt {

namespace {

Color reflected_color(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                      Context& context) {
    Context there = context;
    there.weight *= double(surface.material.mirror);
    if (!worth_reflecting(there.bounces, there.settings.depth, Real(context.weight)))
        return Color(0);
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    context.rays = there.rays;
    return color;
}

}  // namespace

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const auto obstacles = [&](auto& query) { visit_shapes(query, scene); };
    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    const PhongTerms terms =
        mirror < 1 ? lighting(scene, surface, obstacles, context) : PhongTerms{};
    if (mirror == 0) return visible_sum(terms, context);

    const Color own = mirror < 1 ? visible_sum(terms, context) : Color(0);
    return mixed(own, reflected_color(scene, ray, surface, context), mirror);
}

}  // namespace rt
