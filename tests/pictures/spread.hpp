// By how much right answers differ in a picture: its conditioning, pixel by pixel.
#pragma once

#include "common/image.hpp"

#include <string>

namespace rt {

/// The spread of a picture: of each colour, the most by which a right answer has been off, and
/// `not_judged` where that is so much that it tells nothing.
constexpr std::uint8_t not_judged = 255;

// Draws scenes/<name>.rt many times, with rays that are off by as much as the suites let an answer
// be (tolerance, tests/kit/verdict.hpp), and widens the spread to take in what came.
inline namespace f32 {
void widen(Image& spread, const Image& reference, const std::string& name);
}
inline namespace f64 {
void widen(Image& spread, const Image& reference, const std::string& name);
}

}  // namespace rt
