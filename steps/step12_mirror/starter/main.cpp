// Your trace of stage 12 (CR §5.1). This stage adds mirrors: trace calls itself with
// mirrored(ray, surface), and `mixed` adds the two colors, by surface.material.mirror.
//
// The recursion ends by worth_reflecting: context.bounces counts the reflections, and
// context.weight is the product of the mirrors' shares. Both belong to one ray: give the reflected
// ray a Context of its own, a copy, and take its number of rays back: context.rays = there.rays.
#include "common/render/stage.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"

namespace rt {

Color trace(const Scene& scene, const Ray& ray, Context& context) {
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return background(scene, ray);
    if (context.settings.shading == Shading::normal) return color_from_normal(hit->normal);

    const auto obstacles = [&](auto& query) { visit_shapes(query, scene); };
    return visible_sum(lighting(scene, shading_point(*hit, ray), obstacles, context), context);
}

}  // namespace rt
