#include "common/mesh_file/welder.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace rt {

namespace {

std::size_t hash(glm::dvec3 point) {
    std::uint64_t hash = 0;
    for (const double coordinate : {point.x, point.y, point.z}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 29U;
    }
    return std::size_t(hash ^ (hash >> 32U));
}

}  // namespace

std::uint32_t& Welder::slot_of(glm::dvec3 point) {
    std::size_t at = hash(point) & (slots_.size() - 1);
    while (slots_[at] != 0 && places_[slots_[at] - 1] != point) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
}

void Welder::grow() {
    slots_.assign(std::max<std::size_t>(2 * slots_.size(), 64), 0);
    for (std::uint32_t i = 0; i < places_.size(); ++i) slot_of(places_[i]) = i + 1;
}

std::uint32_t Welder::place(glm::dvec3 point) {
    point += 0.0;  // −0 becomes 0
    if (2 * places_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slot_of(point);
    if (slot == 0) {
        places_.push_back(point);
        slot = std::uint32_t(places_.size());
    }
    return slot - 1;
}

}  // namespace rt
