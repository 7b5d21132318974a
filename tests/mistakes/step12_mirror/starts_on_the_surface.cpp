// origin: CR §5.1, whose listing starts at the point and tests t > 0.0001
// caught by: it starts off the surface, by its error or a little more (contract, erratum 31)
// sentence: Your ray starts on the surface that it leaves, and meets it: start surface.error off it.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = surface.point;
    return sent;
}

}  // namespace rt
