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
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<9, "ambient_term">(surface, ambient);
    const Ambient other{.ratio = change->light * ambient.ratio,
                        .color = contract::exchanged(ambient.color, *change)};
    return contract::exchanged_back(contract::ask<9, "ambient_term">(
                                        contract::changed(surface, *change, change->any), other),
                                    *change) /
           change->light;
}

Color diffuse_term(const ShadingPoint& surface, const Light& light) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<9, "diffuse_term">(surface, light);
    return contract::exchanged_back(
               contract::ask<9, "diffuse_term">(contract::changed(surface, *change, change->any),
                                                contract::changed(light, *change, change->any)),
               *change) /
           change->light;
}

Color specular_term(const ShadingPoint& surface, const Light& light) {
    const contract::Change* const change = contract::change();
    if (change == nullptr) return contract::ask<9, "specular_term">(surface, light);
    return contract::exchanged_back(
               contract::ask<9, "specular_term">(contract::changed(surface, *change, change->any),
                                                 contract::changed(light, *change, change->any)),
               *change) /
           change->light;
}

}  // namespace rt
