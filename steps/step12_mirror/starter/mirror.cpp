// Stage 12, to be written. docs/step12_mirror.md explains it, the header is its contract.
// Begin with mirrored. Until the other two are written too, no reflection is visible.
// `./course check 12` reports errors, `./course hint 12` prints the next hint.
#include "steps/step12_mirror/mirror.hpp"

#include "common/stages/todo.hpp"

namespace rt {

namespace {

// Helper functions go here: this namespace is visible in this file only.

}  // namespace

Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    // From a point off the surface, along d − 2 n ⟨d, n⟩ or, if that points inward, a direction
    // that does not.
    RT_TODO(ray, surface);
    return ray;
}

Color mixed(Color own, Color reflection, Real mirror) {
    // The reflection weighted with mirror, and the own color with the rest.
    RT_TODO(own, reflection, mirror);
    return own;
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    // True if one more reflection is allowed and visible.
    RT_TODO(bounces, depth, weight);
    return false;
}

}  // namespace rt
