// origin: invented: the reflected ray gets new settings
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: With --term, your mirror shows all terms. The reflected ray keeps the settings: copy the whole context.
#include "common/render/surface.hpp"

namespace rt {

static Context with_all_terms(Context context) {
    if (context.bounces > 0) context.settings.term = PhongTerm::all;
    return context;
}

}  // namespace rt

#define visible_sum(terms, context) visible_sum(terms, with_all_terms(context))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
