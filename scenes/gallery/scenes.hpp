// The scenes of the gallery that have too many shapes to write by hand. Each function returns the
// text of a scene; the colors are given as `--gamma srgb` shows them.
#pragma once

#include <string>

namespace rt {

/// Stage 3: spheres in the spirals of a sunflower's seeds, on a dome.
[[nodiscard]] std::string sunflower();

/// Stage 5: mountains of triangles around a lake, with a paper boat.
[[nodiscard]] std::string mountains();

/// Stage 6: a wave in a sheet of tiles.
[[nodiscard]] std::string wave_of_tiles();

/// Stage 7: a bamboo grove in the mist.
[[nodiscard]] std::string bamboo();

/// Stage 8: colored pencils, which point to a center.
[[nodiscard]] std::string pencils();

/// Stage 9: a bunch of balloons.
[[nodiscard]] std::string balloons();

/// Stage 12: three large spheres among four hundred small ones, after the cover of Ray Tracing in
/// One Weekend.
[[nodiscard]] std::string marbles();

}  // namespace rt
