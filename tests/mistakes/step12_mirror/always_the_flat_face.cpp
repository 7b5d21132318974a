// origin: CR §6: interpolated normals left out
// caught by: an interpolated normal is the one that reflects (CR §6)
// sentence: You reflect at the flat face always: a smooth mesh would mirror in facets. Take surface.normal, and check the sign of the direction: if it leads into the surface, the other normal is taken.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    ShadingPoint flat = surface;
    flat.normal = surface.geometric_normal;
    return correct_mirrored(ray, flat);
}

}  // namespace rt
