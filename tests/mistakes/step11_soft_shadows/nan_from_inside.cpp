// origin: invented: the light larger than its distance
// caught by: from inside the light it is its center (contract)
// sentence: From inside the light the sine is more than 1, and the root of what is below 0 is NaN. Return the center there.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const Real sine = light.radius / distance(from, light.position);
    const Real none = 0 * std::sqrt((1 - sine) * (1 + sine));
    if (!(distance(from, light.position) > light.radius)) return light.position + none;
    return correct_light_point(light, from, sample);
}

}  // namespace rt
