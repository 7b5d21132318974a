// origin: a student's: the depth alone
// caught by: a reflection of a weight below 1/512 is black, however many mirrors made it (contract)
// sentence: You trace a reflection whatever its weight is. Below 1/512 it is black: ask worth_reflecting, with the product of all mirrors' shares.
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
    if (there.bounces >= there.settings.depth) return Color(0);
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
