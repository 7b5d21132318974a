// origin: invented: d + 2 n ⟨d, n⟩
// caught by: the direction is d - 2 n times d.n (CR §5.1, equation 4)
// sentence: Your ray goes into the mirror, and steeper than before: d + 2 n ⟨d, n⟩ has the wrong sign.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.direction = ray.direction + 2 * dot(ray.direction, surface.normal) * surface.normal;
    return sent;
}

}  // namespace rt
