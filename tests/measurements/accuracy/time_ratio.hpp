// The time of a picture in units of another one's, on a machine that is busy.
#pragma once

#include "tests/measurements/accuracy/drawing.hpp"

#include <functional>

namespace rt {

/// The picture that `draw` returns, and the processor's time that it took.
[[nodiscard]] Drawing timed(const std::function<Image()>& draw);

/// A picture and its time: the two took turns, and the times are those of the processor.
struct TimeRatio {
    Image image;
    double time = 0;      ///< the shortest of all turns, in units of the unit's shortest
    double least = 0;     ///< of the ratios of the turns
    double greatest = 0;  ///< of the same
};

/// Draws in at least two turns, or one that takes seconds; in up to 15 if they are short.
[[nodiscard]] TimeRatio time_ratio(const std::function<Drawing()>& draw,
                                   const std::function<Drawing()>& unit);

}  // namespace rt
