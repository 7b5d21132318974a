// origin: invented: the shares exchanged
// caught by: what it shows and what it reflects are shares of one (contract)
// sentence: You give the mirror the share of the surface, and the surface that of the mirror.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return mirror * own + (1 - mirror) * reflection;
}

}  // namespace rt
