// The spread of right answers in a picture: its conditioning, pixel by pixel.
#pragma once

#include "common/image/image.hpp"

#include <string>

namespace rt {

/// The spread of a picture: for each color, the largest difference of a right answer, and
/// `not_judged` if it is too large for a test.
constexpr std::uint8_t not_judged = 255;

// Renders scenes/<name>.rt many times, with rays perturbed by the suites' tolerance
// (tests/kit/verdict.hpp), and widens the spread to contain the results.
inline namespace f32 {
void widen(Image& spread, const Image& reference, const std::string& name);
}
inline namespace f64 {
void widen(Image& spread, const Image& reference, const std::string& name);
}

}  // namespace rt
