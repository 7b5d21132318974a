// A ray and a shape in the plane through both.
#pragma once

#include "common/contract/smallest.hpp"

#include <string>

namespace rt::contract {

/// True if the call intersects a ray with a shape, so that it can be drawn.
[[nodiscard]] bool can_be_drawn(const Call& call);

/// An SVG of the plane through the ray and the shape's middle: the shape's section, computed by the
/// reference, the ray, the expected hit, and the actual one.
[[nodiscard]] std::string slice(const Difference& difference, Asked& reference);

}  // namespace rt::contract
