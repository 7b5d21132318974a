// An order of which every part is well spread over the whole.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace rt {

/// Returns the numbers below `count` in an order in which successive ones are a golden ratio of the
/// count apart, so that the first few, however many, are well spread.
[[nodiscard]] inline std::vector<std::size_t> spread_order(std::size_t count) {
    constexpr double golden_ratio = 0.6180339887498949;
    auto step = std::max(std::size_t(golden_ratio * double(count)), std::size_t(1));
    while (std::gcd(step, count) > 1) ++step;
    std::vector<std::size_t> order;
    for (std::size_t i = 0, place = 0; i < count; ++i, place = (place + step) % count)
        order.push_back(place);
    return order;
}

}  // namespace rt
