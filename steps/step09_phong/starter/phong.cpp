// Stage 9, to be written: docs/step09_phong.md says how, the header what is promised.
// Begin with ambient_term and diffuse_term: each shows in the picture by itself (--term diffuse).
// specular_term needs reflected.
// `./course check 9` says what is wrong, `./course hint 9` what to think of next.
#include "steps/step09_phong/phong.hpp"

#include "common/todo.hpp"
#include "common/vector.hpp"

#include <cmath>

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    // 2 ⟨L, N⟩ N − L.
    RT_TODO(to_light, normal);
    return Vec3(0);
}

Color ambient_term(const Surface& surface, const Ambient& ambient) {
    // The ambient light's ratio and colour, times the material's colour.
    RT_TODO(surface, ambient);
    return Color(0);
}

Color diffuse_term(const Surface& surface, const Light& light) {
    // By ⟨L, N⟩, in the colours of the light and of the material; nothing where it is not positive.
    RT_TODO(surface, light);
    return Color(0);
}

Color specular_term(const Surface& surface, const Light& light) {
    // By ⟨R, V⟩ to the shininess, in the light's colour; nothing where ⟨L, N⟩ is not positive.
    RT_TODO(surface, light);
    return Color(0);
}

}  // namespace rt
