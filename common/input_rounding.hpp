// What a scene loses where its numbers are rounded to fewer digits: in float, sizes and gaps that
// are small beside the coordinates.
#pragma once

#include "common/scene.hpp"

#include <limits>
#include <string>
#include <vector>

namespace rt {

/// Lengths of a scene that a precision must tell apart.
struct InputRounding {
    double largest = 0;   ///< coordinate of the camera or of a shape
    double smallest = 0;  ///< size of a shape; 0 if none has a size
    /// A twentieth of a shape's surface is no further than this from another shape: 0 where they
    /// coincide, infinite where no gap is so small that float might lose it.
    double gap = std::numeric_limits<double>::infinity();

    /// An upper bound of the distance from a surface to the points of it that are computed with
    /// this unit roundoff, input rounding included (docs/stability.md).
    [[nodiscard]] double displacement(double roundoff) const { return 8 * roundoff * largest; }

    /// Whether that shows at the smallest shape.
    [[nodiscard]] bool loses_sizes(double roundoff) const {
        return smallest > 0 && displacement(roundoff) > smallest / 1000;
    }

    /// Gaps up to so many displacements may close: both surfaces move, and a point leaves one of
    /// them by as much again.
    static constexpr double widest_lost_gap = 4;

    /// Whether of two surfaces that do not coincide either may come out in front.
    [[nodiscard]] bool loses_gaps(double roundoff) const {
        return gap > 0 && gap < widest_lost_gap * displacement(roundoff);
    }
};

inline constexpr double float_unit_roundoff = std::numeric_limits<float>::epsilon() / 2;

}  // namespace rt

namespace rt::inline RT_PRECISION {

/// Of a scene in double: one in float has lost already what this looks for. Meshes count if they
/// are loaded.
[[nodiscard]] InputRounding input_rounding(const Scene& scene);

}  // namespace rt::inline RT_PRECISION

namespace rt::inline f64 {

/// One sentence for each thing that float loses of the scene; none if it is not at risk.
[[nodiscard]] std::vector<std::string> risks_in_float(const InputRounding& scene);

}  // namespace rt::inline f64
