#include "tests/contract/stub.hpp"

namespace rt {

ShadowRay shadow_ray(const Surface& surface, Vec3 light) {
    return contract::ask<10, "shadow_ray">(surface, light);
}

}  // namespace rt
