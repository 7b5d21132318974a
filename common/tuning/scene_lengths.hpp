// The lengths of a scene that decide what a precision may lose.
#pragma once

#include <limits>

namespace rt {

/// The lengths in a scene that a precision must resolve, in units of the scene.
struct SceneLengths {
    double largest = 0;   ///< largest coordinate of the camera or of a shape
    double smallest = 0;  ///< smallest size of a shape; 0 if none has a size
    /// The smallest distance such that for some shape a twentieth of its surface is no farther than
    /// that from another shape: 0 where surfaces coincide, infinite where no gap is so small that
    /// float might lose it.
    double gap = std::numeric_limits<double>::infinity();

    /// An upper bound on the distance from a surface to the points computed on it with this unit
    /// roundoff, including the rounding of the input (docs/reference/stability.md).
    [[nodiscard]] double displacement(double roundoff) const { return 8 * roundoff * largest; }

    /// Returns whether that distance is visible on the smallest shape.
    [[nodiscard]] bool loses_sizes(double roundoff) const {
        return smallest > 0 && displacement(roundoff) > smallest / 1000;
    }

    /// Gaps up to this many displacements may close: both surfaces move, and a point leaves one of
    /// them by as much again.
    static constexpr double widest_lost_gap = 4;

    /// Returns whether rounding may exchange the order of two surfaces that do not coincide.
    [[nodiscard]] bool loses_gaps(double roundoff) const {
        return gap > 0 && gap < widest_lost_gap * displacement(roundoff);
    }
};

inline constexpr double float_unit_roundoff = std::numeric_limits<float>::epsilon() / 2;

}  // namespace rt
