// origin: invented
// caught by: the surface's own part and the reflected part sum to one (contract)
// sentence: You leave out the reflection of a weak mirror. A hundredth of a bright color is seen: worth_reflecting decides what is too little.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return mirror < Real(0.01) ? own : correct_mixed(own, reflection, mirror);
}

}  // namespace rt
