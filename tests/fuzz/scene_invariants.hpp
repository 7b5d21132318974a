// Invariants of every parsed scene. Aborts with a message if one is violated.
#pragma once

#include <string_view>

namespace rt {

/// Compiled twice, as all that reads scenes.
inline namespace f32 {
void check_invariants(std::string_view text);
}
inline namespace f64 {
void check_invariants(std::string_view text);
}

}  // namespace rt
