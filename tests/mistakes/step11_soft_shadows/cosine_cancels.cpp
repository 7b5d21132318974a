// origin: invented: cos θ = 1 − x (1 − cos θ_max), sin θ = √(1 − cos² θ)
// caught by: a light so small that sin² is less than a rounding is sampled all over (contract)
// sentence: Of a small light cos θ_max rounds to 1, and all your points are one. 1 − cos θ_max is sin² / (1 + cos), and sin² is known.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real distance = length(from - light.position);
    const Real sine_max = light.radius / distance;
    const Real cosine_max = std::sqrt(1 - sine_max * sine_max);
    const Real ring = 1 - (1 - sample.x * (1 - cosine_max));
    const Real all = sine_max * sine_max / (1 + cosine_max);
    return correct_light_point(light, from, {std::min(ring / all, Real(0.9999)), sample.y});
}

}  // namespace rt
