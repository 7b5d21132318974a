#include "common/explain/pixel_log.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

void explain_basis(PixelLog& log, const Camera& camera) {
    const Basis basis = camera_basis(camera.direction);
    log.heading("The camera's basis (MRT §2)");
    log.line("o_C", text(camera.position));
    log.line("c", text(camera.direction));
    log.line("X", text(basis.x));
    log.line("Y", text(basis.y));
    log.line("Z", text(basis.z));
}

}  // namespace rt
