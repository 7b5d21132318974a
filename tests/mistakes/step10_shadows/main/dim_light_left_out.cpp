// origin: a student's: a light of less than 1/255 is not seen
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: You leave out light of less than 1/255. Alone it is not seen, but a thousand such lights are.
#include "common/math/vector.hpp"

#include "steps/step09_phong/phong.hpp"

namespace rt {

namespace {

Color unless_dim(Color color) {
    return length(color) < Real(1) / 255 ? Color(0) : color;
}

}  // namespace

}  // namespace rt

#define diffuse_term(...) unless_dim(diffuse_term(__VA_ARGS__))
#include "tests/alternatives/step10_shadows/main/without_a_log.cpp"
