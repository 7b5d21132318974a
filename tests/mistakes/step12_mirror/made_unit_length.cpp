// origin: CR §5.1, whose listing normalizes R
// caught by: the direction is as long as d, whatever its length (contract, erratum 19)
// sentence: You make the direction unit length. A reflection keeps the length of d, and t counts in it.
#define mirrored(...) correct_mirrored(__VA_ARGS__)
#include "steps/step12_mirror/reference/mirror.cpp"
#undef mirrored

#include "common/math/vector.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    Ray sent = correct_mirrored(ray, surface);
    sent.direction = unit(sent.direction);
    return sent;
}

}  // namespace rt
