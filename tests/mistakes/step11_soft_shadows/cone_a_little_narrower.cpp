// origin: invented: 0.98 against samples that miss the sphere by a rounding
// caught by: the points are spread evenly over the solid angle that the light fills (CR §3.3)
// sentence: Your samples leave a part of the visible light out: its rim, its middle or a sector. They are spread over all of it, from x = 0 to 1 and y = 0 to 1.
#define sample_light(...) correct_sample_light(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return correct_sample_light(light, from, {Real(0.98) * sample.x, sample.y});
}

}  // namespace rt
