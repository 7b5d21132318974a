// origin: invented: the radius even instead of the area
// caught by: the points are spread evenly over the solid angle that the light fills (CR §3.3)
// sentence: You take the distance from the middle evenly, so that as many points lie in the inner ring as in an outer one, which is larger: they crowd in the middle. Take its square evenly.
#define sample_light(...) correct_light_point(__VA_ARGS__)
#include "steps/step11_soft_shadows/reference/soft_shadows.cpp"
#undef sample_light

namespace rt {

Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    return correct_light_point(light, from, {sample.x * sample.x, sample.y});
}

}  // namespace rt
