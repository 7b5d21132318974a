#include "tests/measurements/accuracy/time_ratio.hpp"

#include "common/system/countdown.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rt {

Drawing timed(const std::function<Image()>& draw) {
    const double start = cpu_seconds();
    Image image = draw();
    const double seconds = cpu_seconds() - start;
    return {.image = std::move(image), .seconds = seconds};
}

TimeRatio time_ratio(const std::function<Drawing()>& draw, const std::function<Drawing()>& unit) {
    constexpr int most = 15;
    constexpr double enough = 0.1;  // seconds
    constexpr double long_turn = 2;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    TimeRatio ratio{.least = infinite};
    double shortest = infinite;
    double shortest_unit = infinite;
    double all = 0;
    for (int turn = 0; turn < most && all < long_turn; ++turn) {
        if (turn >= 2 && all >= enough) break;
        const double of_unit = unit().seconds;
        Drawing drawing = draw();
        shortest_unit = std::min(shortest_unit, of_unit);
        shortest = std::min(shortest, drawing.seconds);
        ratio.least = std::min(ratio.least, drawing.seconds / of_unit);
        ratio.greatest = std::max(ratio.greatest, drawing.seconds / of_unit);
        ratio.image = std::move(drawing.image);
        all += drawing.seconds;
    }
    ratio.time = shortest / shortest_unit;
    return ratio;
}

}  // namespace rt
