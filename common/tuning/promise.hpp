// The promise of `--tolerance`: how many pixels of a picture may exceed it.
#pragma once

namespace rt {

/// The largest fraction of the pixels whose error may exceed the tolerance.
inline constexpr double few_pixels = 0.01;
/// The same for the pixels in a penumbra, that is, those whose error with one ray per light would
/// exceed the tolerance.
inline constexpr double few_in_penumbrae = 0.1;
/// The same for the pixels of a single tile.
inline constexpr double few_in_a_tile = 0.1;

}  // namespace rt
