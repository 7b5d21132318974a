// origin: CR §5.1, erratum 31: 0.0001, whatever the size of the scene
// caught by: it does not meet the surface that it leaves, however large or small (erratum 31)
// sentence: You start 0.0001 off: past the other side in a small scene, and lost in rounding in a large one.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = surface.point + Real(0.0001) * surface.geometric_normal;
    return sent;
}

}  // namespace rt
