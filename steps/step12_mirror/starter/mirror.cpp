// Stage 12, to be written: docs/step12_mirror.md says how, the header what is promised.
// Begin with mirrored. Until the other two are written too, no mirror shows anything.
// `./course check 12` says what is wrong, `./course hint 12` what to think of next.
#include "steps/step12_mirror/mirror.hpp"

#include "common/todo.hpp"

namespace rt {

namespace {

// Your own helpers go here: what stands in here is seen by this file only.

}  // namespace

Ray mirrored(const Ray& ray, const Surface& surface) {
    // From off the surface, along d − 2 n ⟨d, n⟩ or, if that goes in, another way that does not.
    RT_TODO(ray, surface);
    return ray;
}

Color mixed(Color own, Color reflection, Real mirror) {
    // The mirror's share of the reflection, and the rest of its own.
    RT_TODO(own, reflection, mirror);
    return own;
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    // Whether there may be one more reflection, and whether it would show.
    RT_TODO(bounces, depth, weight);
    return false;
}

}  // namespace rt
