// The story of a light: the vectors of Phong's model, and the results of the stage's functions.
#include "common/explain/pixel_log.hpp"
#include "common/math/vector.hpp"
#include "common/render/surface.hpp"

#include "steps/step09_phong/phong.hpp"

namespace rt {

void explain(PixelLog& log, const ShadingPoint& surface, const Light& light) {
    log.heading("The light at " + text(light.position) + " (CR §3.1)");
    if (light.position == surface.point) {
        log.remark("dark: the light is at the point itself, and has no direction");
        return;
    }
    const Vec3 to_light = unit(light.position - surface.point);
    const Real cosine = dot(to_light, surface.normal);
    log.line("N", text(surface.normal));
    log.line("L", text(to_light));
    log.line("⟨L, N⟩", text(cosine));
    if (cosine <= 0) log.remark("dark: the light is on the other side of the surface");
    if (cosine > 0 && surface.material.specular != 0) {
        const Vec3 direction = reflected(to_light, surface.normal);
        log.line("R = reflected(L, N)", text(direction));
        log.line("V", text(surface.to_eye));
        log.line("⟨R, V⟩", text(dot(direction, surface.to_eye)));
    }
    log.line("diffuse_term", text(diffuse_term(surface, light)));
    log.line("specular_term", text(specular_term(surface, light)));
}

}  // namespace rt
