// Reader of `.rt`, the format of miniRT scenes, in its old and its new dialect. docs/scenes.md
// describes it.
#pragma once

#include "common/math/basis.hpp"
#include "common/scene/scene.hpp"
#include "common/scene_file/reading.hpp"

#include <string>
#include <string_view>

namespace rt {
inline namespace RT_PRECISION {

/// Parses the text of a scene; `file` is the file name in messages. The sides of squares, boxes and
/// meshes follow the basis around their direction (MRT §6). Throws InputError at the first error.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file, BasisAround* basis,
                                const SceneReading& reading = {});

/// Reads a file and calls parse_scene. Throws InputError if the file cannot be read.
[[nodiscard]] Scene load_scene(const std::string& file, BasisAround* basis,
                               const SceneReading& reading = {});

}  // namespace RT_PRECISION
}  // namespace rt
