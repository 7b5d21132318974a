// origin: invented: equation 4 with an interpolated normal, and no more
// caught by: an interpolated normal never sends the ray below the flat face (CR §6)
// sentence: An interpolated normal sends your ray into the face. Test ⟨R, side⟩ > 0.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.direction = ray.direction - 2 * dot(ray.direction, surface.normal) * surface.normal;
    return sent;
}

}  // namespace rt
