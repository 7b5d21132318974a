// origin: invented: one coordinate of the sample used twice
// caught by: the points are spread evenly over the solid angle that the light fills (CR §3.3)
// sentence: You use one number for the distance and for the turn: your points lie on a spiral.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return correct_light_point(light, from, {sample.x, sample.x});
}

}  // namespace rt
