// How a scene is read where the format leaves a choice.
#pragma once

#include "common/scene.hpp"

#include <functional>
#include <string>

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
