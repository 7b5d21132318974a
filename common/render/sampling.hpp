// Deterministic sample points, well spread over a square.
#pragma once

#include "common/image/pixel.hpp"
#include "common/math/real.hpp"

#include <cstdint>

namespace rt {
inline namespace RT_PRECISION {

/// Returns the index-th point of a sequence in [0, 1)²: Sobol's first two dimensions, each
/// Owen-scrambled with the seed (Burley 2020, "Practical Hash-based Owen Scrambling"). Each single
/// point is uniformly distributed over the seeds. Of the first 2^k points, each of 2^k equal boxes
/// contains one, for every division of the square into such boxes by halving.
[[nodiscard]] Vec2 spread_sample(std::uint32_t index, std::uint32_t seed);

/// Returns a permutation of the indices, one for each seed. The first 2^k indices become a block
/// whose points are as well spread as the first 2^k. With it, points of two sequences of the same
/// index are paired at random (Burley 2020).
[[nodiscard]] std::uint32_t shuffled(std::uint32_t index, std::uint32_t seed);

/// Returns a seed that depends only on the pixel and the sampled quantity, so that the result of
/// one thread does not depend on another.
[[nodiscard]] std::uint32_t sample_seed(Pixel pixel, std::uint32_t light, std::uint32_t bounce);

}  // namespace RT_PRECISION
}  // namespace rt
