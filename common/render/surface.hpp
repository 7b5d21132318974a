// The terms of Phong's model at a shading point, their sum, and their explanation.
#pragma once

#include "common/render/context.hpp"
#include "common/scene/light.hpp"
#include "common/scene/shading_point.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// The separate terms of Phong's model.
struct PhongTerms {
    Color ambient{0};
    Color diffuse{0};
    Color specular{0};
};

}  // namespace RT_PRECISION

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
