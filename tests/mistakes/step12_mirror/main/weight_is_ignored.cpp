// origin: a student's: the depth alone
// caught by: a reflection of a weight below 1/512 is black, however many mirrors made it (contract)
// sentence: You trace every reflection, however small its weight is. A reflection of a weight below 1/512 is black: call worth_reflecting with the product of all mirrors' shares.
#define reflection wrong_reflection
#include "steps/step12_mirror/main.cpp"
#undef reflection

namespace rt {

Color wrong_reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                       Context& context) {
    Context there = context;
    there.weight *= double(surface.material.mirror);
    if (there.bounces >= there.settings.depth) return Color(0);
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    context.rays = there.rays;
    return color;
}

}  // namespace rt
