// origin: invented: the radius taken for half of it
// caught by: the point is on the light, on the side that is seen (CR §3.3, erratum 16)
// sentence: Your light is twice as large: light.radius is the radius already.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    Light large = light;
    large.radius *= 2;
    return correct_light_point(large, from, sample);
}

}  // namespace rt
