// The shading point: the geometry and the material that shading a hit requires.
#pragma once

#include "common/render/context.hpp"
#include "common/scene/scene.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// A point on a surface as seen by an eye: lengths in units of the scene.
struct ShadingPoint {
    Vec3 point;
    Vec3 normal;            ///< unit length, on the side of the eye
    Vec3 geometric_normal;  ///< geometric normal: as normal, but never interpolated
    Vec3 to_eye;            ///< unit length
    Real error = 0;         ///< upper bound on the distance from the point to the shape
    Material material;
};

/// The separate terms of Phong's model.
struct PhongTerms {
    Color ambient{0};
    Color diffuse{0};
    Color specular{0};
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// Logs the vectors and cosines of Phong's model at the shading point (CR §3.1).
void explain(PixelLog& log, const ShadingPoint& surface, const Light& light);

/// Logs each term.
void explain(PixelLog& log, const PhongTerms& terms);

/// Returns the sum of the terms, or the single one that --term selects, and logs them.
[[nodiscard]] inline Color visible_sum(const PhongTerms& terms, const Context& context) {
    const auto& [ambient, diffuse, specular] = terms;
    if (context.log != nullptr) explain(*context.log, terms);
    switch (context.settings.term) {
        case PhongTerm::ambient:
            return ambient;
        case PhongTerm::diffuse:
            return diffuse;
        case PhongTerm::specular:
            return specular;
        case PhongTerm::all:
            break;
    }
    return ambient + diffuse + specular;
}

}  // namespace rt
