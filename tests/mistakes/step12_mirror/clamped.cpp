// origin: invented: colors cut off at 1 on the way
// caught by: colors brighter than white are reflected unclamped (contract)
// sentence: You cut colors off at 1 before the picture does: the image of a bright thing gets too dark.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    const auto cut = [](Color color) { return min(color, Color(1)); };
    return (1 - mirror) * cut(own) + mirror * cut(reflection);
}

}  // namespace rt
