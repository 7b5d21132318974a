// origin: invented: break in place of continue
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: A light behind the surface ends your loop over the lights. Go on with the next light.
#include "common/scene/scene.hpp"

#include "steps/step09_phong/phong.hpp"

namespace rt {

static bool is_after_one_behind(const ShadingPoint& surface, const Light& light,
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
#include "tests/alternatives/step13_meshes/main/own_samples.cpp"
