// origin: invented: −d for R
// caught by: the reflected ray stays in the plane of the ray and the normal (CR §5.1)
// sentence: Your mirror reflects every ray back to its origin: R = d − 2 n ⟨d, n⟩.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.direction = -ray.direction;
    return sent;
}

}  // namespace rt
