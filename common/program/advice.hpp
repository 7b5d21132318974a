// What `--requirements` prints of a scene.
#pragma once

#include "common/scene/scene.hpp"

#include <string>
#include <vector>

namespace rt {

/// What is wrong first in a picture with the default settings, because of something in the scene.
struct Advice {
    std::string seen;   ///< in the scene: "a lamp with a size"
    std::string wrong;  ///< in the picture: "grain"
    std::string mends;  ///< an option
    std::string costs;
};

/// Returns the rows of the table in docs/reference/accuracy.md that apply to the scene, as far as
/// it can be seen without its meshes' files.
[[nodiscard]] std::vector<Advice> advice(const Scene& scene);

/// Returns the lines that `--requirements` prints: the scene's requirements, the parts that this
/// program therefore omits, and the advice, each row in at most 80 columns.
[[nodiscard]] std::string explanation(const Scene& scene);

}  // namespace rt
