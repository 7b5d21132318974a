// origin: invented: a mirror that shows nothing of its own
// caught by: a mirror that sees nothing shows its own share (CR §5.1)
// sentence: Your mirror shows nothing of itself: 1 − mirror of it is no mirror.
#define mixed(...) correct_mixed(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mixed

namespace rt {

Color mixed(Color own, Color reflection, Real mirror) {
    return mirror == 0 ? own : mirror * reflection;
}

}  // namespace rt
