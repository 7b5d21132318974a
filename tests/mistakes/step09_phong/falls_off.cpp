// origin: invented: light that falls off with the square of its distance
// caught by: how far away the light is does not matter (CR §3.1)
// sentence: Your light falls off with its distance. That of CR §3.1 does not.
#define diffuse_term(...) correct_diffuse_term(__VA_ARGS__)
#include "steps/step09_phong/reference/phong.cpp"
#undef diffuse_term

namespace rt {

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const Vec3 way = light.position - surface.point;
    return correct_diffuse_term(surface, light) / (1 + dot(way, way));
}

}  // namespace rt
