#include "common/explain/pixel_log.hpp"
#include "common/math/vector.hpp"
#include "common/render/surface.hpp"

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
    if (cosine <= 0) {
        log.remark("dark: the light is on the other side of the surface");
        return;
    }
    if (surface.material.specular == 0) return;
    const Vec3 reflected = 2 * cosine * surface.normal - to_light;
    log.line("R", text(reflected));
    log.line("V", text(surface.to_eye));
    log.line("⟨R, V⟩", text(dot(reflected, surface.to_eye)));
}

}  // namespace rt
