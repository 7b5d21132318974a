// origin: CR §2.1 and §5.1, erratum 30
// caught by: one bounce is one reflection (erratum 30, CR §2.1)
// sentence: You count rays, the first among them: with one bounce, a mirror sees nothing.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces + 1 < depth && weight >= Real(1) / 512;
}

}  // namespace rt
