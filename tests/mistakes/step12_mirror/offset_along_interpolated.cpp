// origin: invented: the offset along the interpolated normal
// caught by: an interpolated normal never sends the ray below the flat face (CR §6)
// sentence: You move the start along the interpolated normal, and less far from the face than its error.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = surface.point + surface.error * surface.normal;
    return sent;
}

}  // namespace rt
