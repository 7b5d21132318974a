// origin: invented
// caught by: the option --depth is the largest number of reflections (CR §5.1)
// sentence: You allow a fixed number of reflections at most, whatever --depth is.
#include "common/math/vector.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"
#include "steps/step12_mirror/mirror.hpp"

#include <algorithm>

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);
    const auto obstacles = [&](auto& query) { visit_shapes(query, scene); };
    const ShadingPoint surface = shading_point(*hit, ray);
    const Real mirror = surface.material.mirror;
    if (mirror == 0) return visible_sum(lighting(scene, surface, obstacles, context), context);
    Color own(0);
    if (mirror < 1) own = visible_sum(lighting(scene, surface, obstacles, context), context);
    Color seen(0);
    const double weight = context.weight * double(mirror);
    if (worth_reflecting(context.bounces, std::min(context.settings.depth, 20), Real(weight))) {
        Context there = context;
        there.bounces = context.bounces + 1;
        there.weight = weight;
        seen = trace(scene, mirrored(ray, surface), there);
        context.rays = there.rays;
    }
    return mixed(own, seen, mirror);
}

}  // namespace rt
