// origin: invented: 0.01, "too little to be seen"
// caught by: a weight of less than 1/512 is not worth a ray (contract)
// sentence: You stop at a weight that does show: a hundredth is more than two steps of the picture's 256.
#define worth_reflecting(...) correct_worth_reflecting(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef worth_reflecting

namespace rt {

bool worth_reflecting(int bounces, int depth, Real weight) {
    return bounces < depth && weight >= Real(0.01);
}

}  // namespace rt
