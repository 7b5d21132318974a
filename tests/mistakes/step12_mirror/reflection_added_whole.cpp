// origin: CR §5.1, whose listing adds it: color +=
// caught by: the surface's own part and the reflected part sum to one (contract)
// sentence: You add all of the reflection, whatever share the surface reflects.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return own + reflection;
}

}  // namespace rt
