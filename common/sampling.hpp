// Points that are spread evenly over a square, the same ones whenever they are asked for.
#pragma once

#include "common/pixel.hpp"
#include "common/real.hpp"

#include <cstdint>

namespace rt::inline RT_PRECISION {

/// The index-th point of a sequence in [0, 1)²: Sobol's first two dimensions, each Owen-scrambled
/// by the seed (Burley 2020, "Practical Hash-based Owen Scrambling"). Each point alone is uniformly
/// distributed over the seeds, and the first 2^k of a sequence lie one in each of 2^k equal boxes,
/// however the square is cut into such by halving.
[[nodiscard]] Vec2 spread_sample(std::uint32_t index, std::uint32_t seed);

/// A seed that belongs to the pixel and to what is sampled there, so that no thread's work depends
/// on another's.
[[nodiscard]] std::uint32_t sample_seed(Pixel pixel, std::uint32_t light, std::uint32_t bounce);

}  // namespace rt::inline RT_PRECISION
