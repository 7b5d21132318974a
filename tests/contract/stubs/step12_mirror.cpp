#include "tests/contract/stub.hpp"

namespace rt {

// Changed by exact transforms only: the ray's start is a few roundings off the surface.
Ray mirrored(const Ray& ray, const ShadingPoint& surface) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<12, "mirrored">(ray, surface);
    const Transform& transform = change->exact;
    return contract::moved_back(
        contract::ask<12, "mirrored">(contract::transformed(ray, transform),
                                      contract::changed(surface, *change, transform)),
        transform);
}

Color mixed(Color own, Color reflection, Real mirror) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<12, "mixed">(own, reflection, mirror);
    return contract::exchanged_back(
               contract::ask<12, "mixed">(contract::exchanged(change->light * own, *change),
                                          contract::exchanged(change->light * reflection, *change),
                                          mirror),
               *change) /
           change->light;
}

// Sent with the same number of bounces left, but with a depth that no suite uses: answers for small
// depths could be tabulated.
bool worth_reflecting(int bounces, int depth, Real weight) {
    const contract::Change* const change = contract::change();
    const int more = change == nullptr ? 0 : 50 * change->finer;
    return contract::ask<12, "worth_reflecting">(bounces + more, depth + more, weight);
}

}  // namespace rt
