#include "common/render/surface.hpp"

#include "common/explain/pixel_log.hpp"

namespace rt {

void explain(PixelLog& log, const PhongTerms& terms) {
    log.heading("The terms of the light (CR §3.1)");
    log.line("ambient", text(terms.ambient));
    log.line("diffuse", text(terms.diffuse));
    log.line("specular", text(terms.specular));
}

}  // namespace rt
