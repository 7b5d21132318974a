// Which of two shapes a ray meets first, where their t are less than a few ulps apart.
#pragma once

#include <cstdint>
#include <string>

namespace rt {

struct Orders {
    std::uint64_t asked = 0;
    std::uint64_t wrong = 0;
    std::string where;  ///< the first that was wrong
};

/// Whether the program's Nearest is that of `--precision exact`.
[[nodiscard]] bool asks_exactly();

/// Two shapes of every pair of kinds, so many times, whose t are 1e-3, ½, 1 and 4 ulps apart, as
/// nearly as numbers let them: in a list and in a hierarchy, in either order.
[[nodiscard]] Orders orders_of_near_ties(std::uint64_t times);

/// Two that are met at the same t, a whole number or √3: the first is the nearest.
[[nodiscard]] Orders orders_of_ties();

}  // namespace rt
