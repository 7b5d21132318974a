// Reads `.rt`, the format that miniRT students write, old and new dialect together.
// docs/scenes.md describes it.
#pragma once

#include "common/input_error.hpp"
#include "common/scene.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace rt {

/// How a scene is read where the format leaves a choice.
struct SceneReading {
    /// Refuse what lenient reading only warns about: unknown keywords, trailing tokens, …
    bool strict = false;
    /// Used unless the file says `# rt: fov=…`.
    FovAxis fov_axis = FovAxis::vertical;
    /// A cylinder's position is its base, not its centre; used unless the file says `# rt: cyl=…`.
    bool cylinder_from_base = false;
    /// Told each warning, "file:line:column: warning: …", once a kind. Nobody, if empty.
    std::function<void(const std::string&)> warn = nullptr;
};

}  // namespace rt

namespace rt::inline RT_PRECISION {

/// The scene that the text describes; `file` is the name that messages use. Throws InputError at
/// the first thing that is wrong. A square's sides follow stage 2's basis (MRT §6), so whoever
/// reads a scene links step02_camera_basis.
[[nodiscard]] Scene parse_scene(std::string_view text, const std::string& file,
                                const SceneReading& reading = {});

/// parse_scene of a file's content. Throws InputError if it cannot be read.
[[nodiscard]] Scene load_scene(const std::string& file, const SceneReading& reading = {});

}  // namespace rt::inline RT_PRECISION
