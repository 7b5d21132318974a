#include "tests/contract/stub.hpp"

namespace rt {

// Which sample leads to which point is not said, and what is asked of the points is not changed by
// a motion.
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

// The contract says of no error what it is: nothing is known of another question's.
Real share_error(const ShadowRays& rays) {
    return contract::ask<11, "share_error">(rays);
}

}  // namespace rt
