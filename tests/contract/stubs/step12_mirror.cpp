#include "tests/contract/stub.hpp"

namespace rt {

Ray mirrored(const Ray& ray, const Surface& surface) {
    return contract::ask<12, "mirrored">(ray, surface);
}

Color mixed(Color own, Color reflection, Real mirror) {
    return contract::ask<12, "mixed">(own, reflection, mirror);
}

bool worth_reflecting(int bounces, int depth, Real weight) {
    return contract::ask<12, "worth_reflecting">(bounces, depth, weight);
}

}  // namespace rt
