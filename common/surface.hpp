// Where an eye looks at a surface: what shading needs to know.
#pragma once

#include "common/context.hpp"
#include "common/scene.hpp"

namespace rt::inline RT_PRECISION {

struct Surface {
    Vec3 point;
    Vec3 normal;     ///< unit length, on the side of the eye
    Vec3 side;       ///< as normal, unless that is interpolated: then of the flat face itself
    Vec3 to_eye;     ///< unit length
    Real error = 0;  ///< no larger is the distance from the point to the shape
    Material material;
};

/// The terms of Phong's model, apart.
struct Terms {
    Color ambient{0};
    Color diffuse{0};
    Color specular{0};
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The vectors and cosines by which Phong's model shades the surface (CR §3.1), in the story.
void tell(Story& story, const Surface& surface, const Light& light);

/// Each term, in the story.
void tell(Story& story, const Terms& terms);

/// The sum of the terms, or the one that --term asks for; told to the story.
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
