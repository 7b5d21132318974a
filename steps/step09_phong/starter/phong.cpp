// Stage 9, to be written. docs/step09_phong.md explains it, the header is its contract.
// Begin with ambient_term and diffuse_term: each is visible separately in the picture (--term
// diffuse). specular_term needs reflected.
// `./course check 9` reports errors, `./course hint 9` prints the next hint.
#include "steps/step09_phong/phong.hpp"

#include "common/math/vector.hpp"
#include "common/stages/todo.hpp"

#include <cmath>

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    // 2 ⟨L, N⟩ N − L.
    RT_TODO(to_light, normal);
    return Vec3(0);
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    // The ambient light's ratio and color, times the material's color.
    RT_TODO(surface, ambient);
    return Color(0);
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    // Proportional to ⟨L, N⟩, in the colors of the light and of the material; black where it is not
    // positive.
    RT_TODO(surface, light);
    return Color(0);
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    // Proportional to ⟨R, V⟩ to the shininess, in the light's color; black where ⟨L, N⟩ is not
    // positive.
    RT_TODO(surface, light);
    return Color(0);
}

}  // namespace rt
