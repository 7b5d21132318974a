// Reads `.rt`, the format that miniRT students write, old and new dialect together.
// docs/scenes.md describes it.
#pragma once

#include "common/basis.hpp"
#include "common/scene.hpp"
#include "common/scene_reading.hpp"

#include <string>
#include <string_view>

namespace rt::inline RT_PRECISION {

/// The scene that the text describes; `file` is the name that messages use. The sides of squares
/// and boxes, and meshes, follow the basis around their direction (MRT §6). Throws InputError at
/// the first thing that is wrong.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file, BasisAround* basis,
                                const SceneReading& reading = {});

/// parse_scene of a file's content. Throws InputError if it cannot be read.
[[nodiscard]] Scene load_scene(const std::string& file, BasisAround* basis,
                               const SceneReading& reading = {});

}  // namespace rt::inline RT_PRECISION
