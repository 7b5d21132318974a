// origin: invented: stage 10 once more
// caught by: another sample is another point (CR §3.3)
// sentence: You aim at the light's center, whatever the sample: the shadow stays hard.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return light.position;
}

}  // namespace rt
