// origin: invented: the depth alone
// caught by: shares of 0.1 stop after two reflections: 0.001 would not show (contract)
// sentence: You trace reflections that no pixel shows: test first that the weight is at least 1/512, which is Real(1) / 512 in C++.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces < depth;
}

}  // namespace rt
