#include "tests/contract/stub.hpp"

namespace rt {

// Not changed: the contract does not determine the point of a sample, and the tested properties of
// the points are invariant under transforms.
Vec3 light_point(const Light& light, Vec3 from, Vec2 sample) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<11, "light_point">(light, from, sample);
    return contract::moved_back(
        contract::ask<11, "light_point">(contract::changed(light, *change, change->any),
                                         moved(from, change->any), sample),
        change->any);
}

Real lit_share(const ShadowRays& rays) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<11, "lit_share">(rays);
    return contract::ask<11, "lit_share">(
        ShadowRays{.sent = change->finer * rays.sent, .reached = change->finer * rays.reached});
}

// Not changed: the contract does not determine the error, so the answer to another query is
// unknown.
Real share_error(const ShadowRays& rays) {
    return contract::ask<11, "share_error">(rays);
}

}  // namespace rt
