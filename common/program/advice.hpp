// The text that `--requirements` prints about a scene.
#pragma once

#include "common/scene/scene.hpp"

#include <string>
#include <vector>

namespace rt {

/// A visible error of a picture with the default settings, and the option that reduces it.
struct Advice {
    std::string seen;   ///< its cause in the scene: "a lamp with a size"
    std::string wrong;  ///< the error in the picture: "grain"
    std::string mends;  ///< the option
    std::string costs;  ///< the price of the option, in time or rays
};

/// Returns the rows of the table in docs/reference/accuracy.md that apply to the scene, as far as
/// it can be seen without its meshes' files.
[[nodiscard]] std::vector<Advice> advice(const Scene& scene);

/// Returns the lines that `--requirements` prints: the scene's requirements, the parts that this
/// program therefore omits, and the advice, each row in at most 80 columns.
[[nodiscard]] std::string explanation(const Scene& scene);

}  // namespace rt
