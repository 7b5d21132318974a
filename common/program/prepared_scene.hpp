// The scene of the command line, ready for rays.
#pragma once

#include "common/program/options.hpp"
#include "common/scene/scene.hpp"

namespace rt {
inline namespace RT_PRECISION {

/// Reads the scene and its meshes, with the selected camera in front, and builds its acceleration
/// structures. Throws InputError if a file is wrong, if a later stage introduces what the scene
/// requires, or if the output is one of the meshes. With `--requirements` it only reads the scene.
[[nodiscard]] Scene prepared_scene(const Program& program, const Options& options);

/// Prints warnings on the standard error; nothing with `--quiet`.
[[nodiscard]] Warn warn_unless_quiet(const Options& options);

/// The acceleration structures of the program's stage. In the stages about shapes there are no
/// bounding spheres, so that a wrong formula is visible.
[[nodiscard]] Acceleration acceleration_of(const Program& program, const Options& options);

}  // namespace RT_PRECISION
}  // namespace rt
