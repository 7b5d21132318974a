#include "steps/step12_mirror/reflection.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/render/stage.hpp"

#include "steps/step12_mirror/mirror.hpp"

#include <string>

namespace rt {

namespace {

// Of `--pixel` alone: not a part of the code for every ray.

[[gnu::noinline]] void explain_end(PixelLog& log) {
    log.remark("no reflection is worth its ray any more");
}

[[gnu::noinline]] void explain_return(PixelLog& log, int bounces, Color color) {
    log.heading("Back at the mirror, reflection " + std::to_string(bounces));
    log.line("color of the reflection", text(color));
}

}  // namespace

// Inlined into `trace`, it would cost a scene without mirrors 1 % of its instructions.
[[gnu::noinline]] Color reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                                   Context& context) {
    Context there = context;
    there.weight *= double(surface.material.mirror);
    if (!worth_reflecting(context.bounces, context.settings.depth, Real(there.weight))) {
        if (context.log != nullptr) [[unlikely]]
            explain_end(*context.log);
        return Color(0);
    }
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    if (context.log != nullptr) [[unlikely]]
        explain_return(*context.log, there.bounces, color);
    context.rays = there.rays;
    context.sized_light_rays = there.sized_light_rays;
    return color;
}

}  // namespace rt
