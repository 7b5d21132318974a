// The result of reading a scene file, in either precision.
#pragma once

#include <string>

namespace rt {

struct Outcome {
    bool accepted = false;
    std::string message;  ///< the error message if it is refused
};

/// Compiled twice, as all that reads scenes.
inline namespace f32 {
[[nodiscard]] Outcome read_outcome(const std::string& file, bool strict);
}
inline namespace f64 {
[[nodiscard]] Outcome read_outcome(const std::string& file, bool strict);
}

}  // namespace rt
