// Options for reading a scene where the format is ambiguous.
#pragma once

#include "common/scene/axes.hpp"
#include "common/scene/scene.hpp"
#include "common/system/input_error.hpp"

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

}  // namespace rt
