#include "common/explain/pixel_log.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

namespace rt {

void tell_basis(Story& story, const Camera& camera) {
    const Basis basis = camera_basis(camera.direction);
    story.heading("The camera's basis (MRT §2)");
    story.line("o_C", text(camera.position));
    story.line("c", text(camera.direction));
    story.line("X", text(basis.x));
    story.line("Y", text(basis.y));
    story.line("Z", text(basis.z));
}

}  // namespace rt
