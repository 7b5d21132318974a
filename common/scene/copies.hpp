// Removal of duplicate shapes from a list, because no hierarchy of boxes can separate them.
#pragma once

#include "common/geometry/bounding_box.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

namespace rt {

/// A hash of points: equal for equal points, and seldom equal for different ones.
[[nodiscard]] inline std::size_t hash(std::initializer_list<Vec3> points) {
    std::uint64_t hash = 0;
    for (const Vec3& point : points)
        for (const Real coordinate : {point.x, point.y, point.z}) {
            hash = (hash ^ std::hash<Real>()(coordinate)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29U;
        }
    return std::size_t(hash);
}

/// Returns whether two elements of a sample have the same hash. A sample suffices, because only a
/// large number of copies costs time.
template <class T, class HashOf>
[[nodiscard]] bool may_have_copies(const std::vector<T>& all, HashOf hash_of) {
    constexpr std::size_t most_sampled = 4096;
    const std::size_t step = all.size() / most_sampled + 1;
    std::vector<std::size_t> hashes;
    for (std::size_t i = 0; i < all.size(); i += step) hashes.push_back(hash_of(all[i]));
    std::sort(hashes.begin(), hashes.end());
    return std::adjacent_find(hashes.begin(), hashes.end()) != hashes.end();
}

/// Removes each element that equals an earlier one. Equal elements must have equal hashes; an
/// element is compared with at most a few others of the same hash.
template <class T, class HashOf, class Same>
void leave_out_copies(std::vector<T>& all, HashOf hash_of, Same same) {
    constexpr std::size_t most_compared = 8;
    if (!may_have_copies(all, hash_of)) return;
    std::vector<std::pair<std::size_t, std::size_t>> order;  // hash, index
    order.reserve(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) order.emplace_back(hash_of(all[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<bool> is_copy(all.size());
    std::vector<std::size_t> others;  // elements with the same hash
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto [hash, index] = order[i];
        if (i == 0 || hash != order[i - 1].first) others.clear();
        const T& item = all[index];
        is_copy[index] = std::any_of(others.begin(), others.end(),
                                     [&](std::size_t other) { return same(all[other], item); });
        if (!is_copy[index] && others.size() < most_compared) others.push_back(index);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!is_copy[i]) all[kept++] = all[i];
    all.erase(all.begin() + std::ptrdiff_t(kept), all.end());
}

}  // namespace rt
