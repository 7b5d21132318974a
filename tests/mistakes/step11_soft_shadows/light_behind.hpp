// For a loop over the lights that ends at the first one behind the surface.
#pragma once

#include "common/scene/scene.hpp"

#include "steps/step09_phong/phong.hpp"

namespace rt {

inline bool is_after_one_behind(const ShadingPoint& surface, const Light& light,
                                const Scene& scene) {
    for (const Light& before : scene.lights) {
        if (&before == &light) return false;
        if (!(dot(before.position - surface.point, surface.normal) > 0)) return true;
    }
    return false;
}

}  // namespace rt

#define diffuse_term(surface, light) \
    (is_after_one_behind(surface, light, scene) ? Color(0) : diffuse_term(surface, light))
#define specular_term(surface, light) \
    (is_after_one_behind(surface, light, scene) ? Color(0) : specular_term(surface, light))
