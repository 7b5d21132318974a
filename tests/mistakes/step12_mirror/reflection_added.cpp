// origin: invented: own + mirror · reflection
// caught by: a mirror in a room of its own color is not seen: the shares add up (contract)
// sentence: You add the reflection and take nothing from what the surface shows: it gives more light than it gets.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return own + mirror * reflection;
}

}  // namespace rt
