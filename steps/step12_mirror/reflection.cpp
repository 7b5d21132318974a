#include "steps/step12_mirror/reflection.hpp"

#include "common/explain/pixel_log.hpp"
#include "common/render/stage.hpp"

#include "steps/step12_mirror/mirror.hpp"

#include <string>

namespace rt {

namespace {

void explain(PixelLog& log, const Ray& ray, const ShadingPoint& surface) {
    log.heading("The mirror (CR §5.1)");
    log.line("d", text(ray.direction));
    log.line("n", text(surface.normal));
}

}  // namespace

Color reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                 Context& context) {
    Context there = context;
    there.weight *= double(surface.material.mirror);
    if (context.log != nullptr) explain(*context.log, ray, surface);
    if (!worth_reflecting(context.bounces, context.settings.depth, Real(there.weight))) {
        if (context.log != nullptr) context.log->remark("no reflection is worth its ray any more");
        return Color(0);
    }
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    if (context.log != nullptr) {
        context.log->heading("Back at the mirror, reflection " + std::to_string(there.bounces));
        context.log->line("color of the reflection", text(color));
    }
    context.rays = there.rays;
    context.sized_light_rays = there.sized_light_rays;
    return color;
}

}  // namespace rt
