// origin: invented: the sign of the offset
// caught by: it starts off the surface, by its error or a little more (contract, erratum 31)
// sentence: Your ray starts on the other side of the surface: surface.geometric_normal is on the side of the eye.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = surface.point - surface.error * surface.geometric_normal;
    return sent;
}

}  // namespace rt
