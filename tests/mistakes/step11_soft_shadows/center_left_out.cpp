// origin: invented: the light's center not added
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: Your points lie around the origin of the world. Add light.position.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return correct_light_point(light, from, sample) - light.position;
}

}  // namespace rt
