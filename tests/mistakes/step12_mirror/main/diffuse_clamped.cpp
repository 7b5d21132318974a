// origin: invented: the sum of the lights is limited to white
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: You limit the light of all lamps to white before the mirror's share is taken. Only the pixel's color is limited, at the end.
#include "common/render/surface.hpp"

namespace rt {

static Color clamped_sum(PhongTerms terms, const Context& context) {
    terms.diffuse = glm::min(terms.diffuse, Color(1));
    return visible_sum(terms, context);
}

}  // namespace rt

#define visible_sum(terms, context) clamped_sum(terms, context)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
