#include "common/render/surface.hpp"

#include "common/explain/pixel_log.hpp"

namespace rt {

void tell(Story& story, const Terms& terms) {
    story.heading("The terms of the light (CR §3.1)");
    story.line("ambient", text(terms.ambient));
    story.line("diffuse", text(terms.diffuse));
    story.line("specular", text(terms.specular));
}

}  // namespace rt
