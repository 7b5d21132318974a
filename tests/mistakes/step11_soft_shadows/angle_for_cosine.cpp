// origin: invented: the angle even instead of its cosine
// caught by: the points are spread evenly over the solid angle that the light fills (CR §3.3)
// sentence: You take the angle θ evenly from 0 to its largest. Rings of equal θ are not of equal solid angle: take cos θ evenly.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    if (!(distance(from, light.position) > light.radius)) return light.position;
    const Real largest = std::asin(light.radius / distance(from, light.position));
    const Real ring = std::sin(sample.x * largest / 2) / std::sin(largest / 2);
    return correct_light_point(light, from, {ring * ring, sample.y});
}

}  // namespace rt
