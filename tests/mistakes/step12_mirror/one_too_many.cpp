// origin: invented: <= for <
// caught by: between two facing mirrors a ray is reflected --depth times (CR §5.1)
// sentence: You make one reflection more than the depth allows.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces <= depth && weight >= Real(1) / 512;
}

}  // namespace rt
