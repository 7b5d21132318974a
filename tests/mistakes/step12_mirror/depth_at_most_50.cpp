// origin: a student's: MAX_DEPTH
// caught by: one bounce is one reflection (erratum 30, CR §2.1)
// sentence: You allow a fixed number of reflections at most, whatever the depth is.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces < 50 && correct_worth_reflecting(bounces, depth, weight);
}

}  // namespace rt
