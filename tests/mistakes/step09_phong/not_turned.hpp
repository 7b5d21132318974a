// For a trace that turns the normals of some kinds of shapes to the eye, and of others not.
#pragma once

#include "common/render/closest_hit.hpp"

namespace rt {

/// As shading_point, but the normal of a shape in the lists stays as it is.
template <class... Lists>
ShadingPoint shading_point_but_for(const Hit& hit, const Ray& ray, const Lists&... lists) {
    ShadingPoint surface = shading_point(hit, ray);
    const auto leave = [&](const auto& list) {
        for (const auto& primitive : list)
            if (hit.material == &primitive.material) surface.normal = hit.normal;
    };
    (leave(lists), ...);
    return surface;
}

}  // namespace rt
