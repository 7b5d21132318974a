// origin: CR §3.1: 2 ⟨L, N⟩ N − L, with d for L
// caught by: a ray straight at the mirror is reflected straight back (CR §5.1)
// sentence: You use stage 9's formula, whose L leads away from the surface. d leads to it: d − 2 n ⟨d, n⟩.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.direction = 2 * dot(ray.direction, surface.normal) * surface.normal - ray.direction;
    return sent;
}

}  // namespace rt
