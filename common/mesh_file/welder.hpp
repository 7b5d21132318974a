// Numbers for places, the same for the same place.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace rt {

/// Numbers places from 0, in the order in which they come: a hash table of open addresses.
class Welder {
public:
    /// Returns the number of a place that came before, else the next number. Coordinates are equal
    /// only if all of their digits are.
    std::uint32_t place(glm::dvec3 point);

private:
    [[nodiscard]] std::uint32_t& slot_of(glm::dvec3 point);
    void grow();

    std::vector<glm::dvec3> places_;
    std::vector<std::uint32_t> slots_;  ///< numbers from 1; 0 is free. A power of two of them
};

}  // namespace rt
