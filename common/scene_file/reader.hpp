// Reader of `.rt`, the format of miniRT scenes, in its old and its new dialect. docs/scenes.md
// describes it.
#pragma once

#include "common/math/basis.hpp"
#include "common/scene/axes.hpp"
#include "common/scene/scene.hpp"
#include "common/system/input_error.hpp"

#include <string>
#include <string_view>

namespace rt {

/// Options for reading a scene where the format is ambiguous.
struct SceneReading {
    /// Report an error where lenient reading only warns: unknown keywords, trailing tokens, …
    bool strict = false;
    /// Default for a file without `# rt: fov=…`.
    FovAxis fov_axis = FovAxis::vertical;
    /// A cylinder's position is its base, not its center; default for a file without `# rt: cyl=…`.
    bool cylinder_from_base = false;
    /// Default for a file without `# rt: hand=…` or `# rt: up=…`.
    Axes axes{};
    /// Receives each warning, "file:line:column: warning: …", the first of its kind only. An empty
    /// function discards them.
    Warn warn = nullptr;
};

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
