// origin: invented: the origin left as it is
// caught by: it starts off the surface, by its error or a little more (contract, erratum 31)
// sentence: Your reflected ray starts at the eye. It starts where the mirror was met.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = ray.origin;
    return sent;
}

}  // namespace rt
