#include "steps/step12_mirror/reflection.hpp"

#include "common/render/stage.hpp"

#include "steps/step12_mirror/mirror.hpp"

namespace rt {

Color reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                 Context& context) {
    Context there = context;
    there.weight *= double(surface.material.mirror);
    if (!worth_reflecting(context.bounces, context.settings.depth, Real(there.weight)))
        return Color(0);
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    context.rays = there.rays;
    context.sized_light_rays = there.sized_light_rays;
    return color;
}

}  // namespace rt
