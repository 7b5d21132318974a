#include "tests/contract/stub.hpp"

namespace rt {

// Changed by exact transforms only: the suite measures the ray's offset in roundings.
ShadowRay shadow_ray(const ShadingPoint& surface, Vec3 light) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<10, "shadow_ray">(surface, light);
    const Transform& transform = change->exact;
    const auto [ray, interval] = contract::ask<10, "shadow_ray">(
        contract::changed(surface, *change, transform), transformed(light, transform));
    return {.ray = contract::moved_back(ray, transform), .interval = interval};
}

}  // namespace rt
