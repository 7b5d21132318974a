#include "tests/contract/stub.hpp"

namespace rt {

// Not changed: the contract does not determine the point of a sample, and the tested properties of
// the points are invariant under transforms.
Vec3 sample_light(const Light& light, Vec3 from, Vec2 sample) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<11, "sample_light">(light, from, sample);
    return contract::moved_back(
        contract::ask<11, "sample_light">(contract::changed(light, *change, change->any),
                                          transformed(from, change->any), sample),
        change->any);
}

Real visibility(const ShadowRays& rays) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<11, "visibility">(rays);
    return contract::ask<11, "visibility">(
        ShadowRays{.sent = change->finer * rays.sent, .reached = change->finer * rays.reached});
}

// Not changed: the contract does not determine the error, so the answer to another query is
// unknown.
Real visibility_error(const ShadowRays& rays) {
    return contract::ask<11, "visibility_error">(rays);
}

}  // namespace rt
