#include "tests/contract/stub.hpp"

namespace rt {

Vec3 reflected(Vec3 to_light, Vec3 normal) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<9, "reflected">(to_light, normal);
    const Transform& transform = change->any;
    return contract::turned_back(
        contract::ask<9, "reflected">(rotated(to_light, transform), rotated(normal, transform)),
        transform);
}

Color ambient_term(const ShadingPoint& surface, const Ambient& ambient) {
    return contract::ask_color<9, "ambient_term">(surface, ambient);
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    return contract::ask_color<9, "diffuse_term">(surface, light);
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    return contract::ask_color<9, "specular_term">(surface, light);
}

}  // namespace rt
