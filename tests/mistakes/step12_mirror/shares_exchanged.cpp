// origin: invented: the shares exchanged
// caught by: the surface's own part and the reflected part sum to one (contract)
// sentence: You give the mirror the share of the surface, and the surface that of the mirror.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return mirror * own + (1 - mirror) * reflection;
}

}  // namespace rt
