// origin: seen in student repositories: no bound on depth
// caught by: no more reflections than the depth: there is a bound (contract)
// sentence: Nothing bounds the number of reflections: between two perfect mirrors your program never ends.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return weight >= Real(1) / 512;
}

}  // namespace rt
