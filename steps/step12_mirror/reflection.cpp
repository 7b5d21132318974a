#include "steps/step12_mirror/reflection.hpp"

#include "common/stage.hpp"

#include "steps/step12_mirror/mirror.hpp"

namespace rt {

Color reflection(const Scene& scene, const Ray& ray, const Surface& surface, Context& context) {
    const double weight = context.weight;
    const double weight_there = weight * double(surface.material.mirror);
    if (!worth_reflecting(context.bounces, context.look.depth, Real(weight_there))) return Color(0);
    ++context.bounces;
    context.weight = weight_there;
    const Color color = trace(scene, mirrored(ray, surface), context);
    --context.bounces;
    context.weight = weight;
    return color;
}

}  // namespace rt
