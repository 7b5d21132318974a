// origin: a student's: 1/512, rounded
// caught by: a weight of less than 1/512 is not worth a ray (contract)
// sentence: You round 1/512, which is 0.001953125. Write Real(1) / 512.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces < depth && weight >= Real(0.00195);
}

}  // namespace rt
