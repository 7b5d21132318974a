// Colour, where there is a terminal to see it.
#pragma once

#include <string>

namespace rt {

enum class Paint { good, bad, bold, dim };

/// The text in colour, if the standard output is a terminal and NO_COLOR is not set.
[[nodiscard]] std::string painted(const std::string& text, Paint paint);

}  // namespace rt
