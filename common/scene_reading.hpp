// How a scene is read where the format leaves a choice.
#pragma once

#include "common/axes.hpp"
#include "common/input_error.hpp"
#include "common/scene.hpp"

namespace rt {

/// How a scene is read where the format leaves a choice.
struct SceneReading {
    /// Refuse what lenient reading only warns about: unknown keywords, trailing tokens, …
    bool strict = false;
    /// Used unless the file says `# rt: fov=…`.
    FovAxis fov_axis = FovAxis::vertical;
    /// A cylinder's position is its base, not its centre; used unless the file says `# rt: cyl=…`.
    bool cylinder_from_base = false;
    /// Used unless the file says `# rt: hand=…` or `# rt: up=…`.
    Axes axes{};
    /// Told each warning, "file:line:column: warning: …", once a kind. Nobody, if empty.
    Warn warn = nullptr;
};

}  // namespace rt
