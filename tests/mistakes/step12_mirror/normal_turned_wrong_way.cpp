// origin: seen in student repositories: the sign of the normal wrong when seen from inside
// caught by: in a mirror all around, a ray goes round the square, and sees behind its start (CR §5.1)
// sentence: From inside, your ray leaves on the other side: surface.normal is on the side of the eye already.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

#include <cmath>

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    // As if it were outward: "inside" is where it and the way to the center agree.
    const bool inside = dot(surface.point, surface.normal) < 0;
    const Vec3 n = inside ? -surface.normal : surface.normal;
    const Vec3 d = ray.direction;
    const Real cosine = std::abs(dot(d, n));
    return {.origin = surface.point + surface.error * n, .direction = d + 2 * cosine * n};
}

}  // namespace rt
