// A difference as texts: a line of a suite, to be pasted, and a drawing.
#pragma once

#include "common/contract/smallest.hpp"

#include <string>

namespace rt::contract {

/// "CHECK(hits(Ray{…}, Sphere{…}, 4));"
[[nodiscard]] std::string paste_line(const Call& call, const Value& expected);

/// "a hit at t = 4", "no hit", "{0, 0, 1}", "your code crashed: Segmentation fault"
[[nodiscard]] std::string answer_text(const Call& call, const Answer& answer);

/// True if the call intersects a ray with a shape, so that it can be drawn.
[[nodiscard]] bool can_be_drawn(const Call& call);

/// An SVG of the plane through the ray and the shape's middle: the shape's section, computed by the
/// reference, the ray, the expected hit, and the actual one.
[[nodiscard]] std::string slice(const Difference& difference, Asked& reference);

}  // namespace rt::contract
