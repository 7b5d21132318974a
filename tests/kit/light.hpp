// Random surfaces and lights, and their text as C++.
#pragma once

#include "tests/kit/for_all.hpp"

#include "common/explain/text.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

namespace rt {

inline std::string code(const Material& material) {
    return "Material{.color = " + code(material.color) +
           ", .specular = " + code(material.specular) +
           ", .shininess = " + code(material.shininess) + ", .mirror = " + code(material.mirror) +
           "}";
}

inline std::string code(const ShadingPoint& surface) {
    return "ShadingPoint{.point = " + code(surface.point) + ", .normal = " + code(surface.normal) +
           ", .geometric_normal = " + code(surface.geometric_normal) +
           ", .to_eye = " + code(surface.to_eye) + ", .error = " + code(surface.error) +
           ", .material = " + code(surface.material) + "}";
}

inline std::string code(const Light& light) {
    return "Light{.position = " + code(light.position) +
           ", .brightness = " + code(light.brightness) + ", .color = " + code(light.color) +
           ", .radius = " + code(light.radius) + "}";
}

/// A surface at the point, seen from any direction on the normal's side.
inline ShadingPoint draw_surface(Random& random, Vec3 point) {
    const Vec3 normal = random.direction();
    Vec3 to_eye = random.direction();
    if (dot(to_eye, normal) < 0) to_eye = -to_eye;
    return {.point = point,
            .normal = normal,
            .geometric_normal = normal,
            .to_eye = to_eye,
            .error = 64 * unit_roundoff * (1 + length(point)),
            .material = {.color = abs(random.point(1)), .specular = random.between(0, 1)}};
}

}  // namespace rt
