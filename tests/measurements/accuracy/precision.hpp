// The name of a program's precision in its output.
#pragma once

#include "common/math/real.hpp"

namespace rt {
inline namespace RT_PRECISION {

inline constexpr const char* precision_word = sizeof(Real) == 4 ? "float" : "double";

}  // namespace RT_PRECISION
}  // namespace rt
