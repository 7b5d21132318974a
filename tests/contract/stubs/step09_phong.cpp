#include "tests/contract/stub.hpp"

namespace rt {

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    return contract::ask<9, "reflected">(to_light, normal);
}

Color ambient_term(const Surface& surface, const Ambient& ambient) {
    return contract::ask<9, "ambient_term">(surface, ambient);
}

Color diffuse_term(const Surface& surface, const Light& light) {
    return contract::ask<9, "diffuse_term">(surface, light);
}

Color specular_term(const Surface& surface, const Light& light) {
    return contract::ask<9, "specular_term">(surface, light);
}

}  // namespace rt
