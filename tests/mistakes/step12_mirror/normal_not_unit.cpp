// origin: CR equation 4, erratum 29: n need not be of unit length there
// caught by: the direction is d - 2 n times d.n (CR §5.1, equation 4)
// sentence: You reflect at a vector that is not of unit length: R = d − 2 n ⟨d, n⟩ is true for ‖n‖ = 1 only.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    const Vec3 n = surface.normal + surface.geometric_normal;  // meant as the mean of both
    sent.direction = ray.direction - 2 * dot(ray.direction, n) * n;
    return sent;
}

}  // namespace rt
