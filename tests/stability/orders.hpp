// The order of two shapes along a ray whose t differ by less than a few ulps.
#pragma once

#include <cstdint>
#include <string>

namespace rt {

struct Orders {
    std::uint64_t asked = 0;
    std::uint64_t wrong = 0;
    std::string where;  ///< the first that was wrong
};

/// For every pair of kinds, `times` pairs of shapes whose t are 1e-3, ½, 1 and 4 ulps apart, within
/// rounding: in a list and in a BVH, in either order.
[[nodiscard]] Orders orders_of_near_ties(std::uint64_t times);

/// Two that are hit at the same t, a whole number or √3: the first is the nearest.
[[nodiscard]] Orders orders_of_ties();

}  // namespace rt
