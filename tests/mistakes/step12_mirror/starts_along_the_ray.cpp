// origin: seen in student repositories: the offset along the direction
// caught by: it starts off the surface, by its error or a little more (contract, erratum 31)
// sentence: You move the start along the ray: where that is flat, it stays on the surface. Move along surface.geometric_normal.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

#include "common/math/vector.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.origin = surface.point + surface.error * unit(sent.direction);
    return sent;
}

}  // namespace rt
