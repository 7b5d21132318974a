// The shading point: the geometry and the material that shading a hit requires.
#pragma once

#include "common/render/context.hpp"
#include "common/scene/scene.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// A point on a surface as seen by an eye: lengths in units of the scene.
struct Surface {
    Vec3 point;
    Vec3 normal;     ///< unit length, on the side of the eye
    Vec3 side;       ///< geometric normal: as normal, but never interpolated
    Vec3 to_eye;     ///< unit length
    Real error = 0;  ///< upper bound on the distance from the point to the shape
    Material material;
};

/// The separate terms of Phong's model.
struct Terms {
    Color ambient{0};
    Color diffuse{0};
    Color specular{0};
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// Logs the vectors and cosines of Phong's model at the shading point (CR §3.1).
void tell(Story& story, const Surface& surface, const Light& light);

/// Logs each term.
void tell(Story& story, const Terms& terms);

/// Returns the sum of the terms, or the single one that --term selects, and logs them.
[[nodiscard]] inline Color shown(const Terms& terms, const Context& context) {
    const auto& [ambient, diffuse, specular] = terms;
    if (context.story != nullptr) tell(*context.story, terms);
    switch (context.look.term) {
        case Term::ambient:
            return ambient;
        case Term::diffuse:
            return diffuse;
        case Term::specular:
            return specular;
        case Term::all:
            break;
    }
    return ambient + diffuse + specular;
}

}  // namespace rt
