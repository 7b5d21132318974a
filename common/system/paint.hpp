// Color on a terminal.
#pragma once

#include <string>

namespace rt {

enum class Paint { good, bad, bold, dim };

/// The text in color, if the standard output is a terminal and NO_COLOR is not set.
[[nodiscard]] std::string painted(const std::string& text, Paint paint);

}  // namespace rt
