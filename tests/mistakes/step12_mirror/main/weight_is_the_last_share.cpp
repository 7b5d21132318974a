// origin: a student's: = in place of *=
// caught by: a reflection of a weight below 1/512 is black, however many mirrors made it (contract)
// sentence: The weight of your reflection is the share of the last mirror alone. It is the product of the shares of all mirrors so far: there.weight = context.weight * mirror.
#define reflection wrong_reflection
#include "steps/step12_mirror/main.cpp"
#undef reflection

namespace rt {

Color wrong_reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
                       Context& context) {
    Context there = context;
    there.weight = double(surface.material.mirror);
    if (!worth_reflecting(there.bounces, there.settings.depth, Real(there.weight))) return Color(0);
    ++there.bounces;
    const Color color = trace(scene, mirrored(ray, surface), there);
    context.rays = there.rays;
    return color;
}

}  // namespace rt
