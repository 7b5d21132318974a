#include "common/surface.hpp"

#include "common/story.hpp"

namespace rt {

Color shown(const Terms& terms, const Context& context) {
    const auto& [ambient, diffuse, specular] = terms;
    if (context.story != nullptr) {
        context.story->heading("The terms of the light (CR §3.1)");
        context.story->line("ambient", text(ambient));
        context.story->line("diffuse", text(diffuse));
        context.story->line("specular", text(specular));
    }
    switch (context.look.term) {
        case Term::ambient:
            return ambient;
        case Term::diffuse:
            return diffuse;
        case Term::specular:
            return specular;
        case Term::all:
            break;
    }
    return ambient + diffuse + specular;
}

}  // namespace rt
