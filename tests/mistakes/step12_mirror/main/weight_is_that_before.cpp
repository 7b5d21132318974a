// origin: a student's: the call of worth_reflecting before the multiplication by the share
// caught by: a reflection of a weight below 1/512 is black, however many mirrors made it (contract)
// sentence: You call worth_reflecting with the weight of the arriving ray. The weight of the reflection is the product of that weight and this mirror's share.
#define reflection wrong_reflection
#include "steps/step12_mirror/main.cpp"
#undef reflection

namespace rt {

Color wrong_reflection(const Scene& scene, const Ray& ray, const ShadingPoint& surface,
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

}  // namespace rt
