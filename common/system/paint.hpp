// Color on a terminal.
#pragma once

#include <string>

namespace rt {

enum class Style { good, bad, bold, dim };

/// The text in color, if the standard output is a terminal and NO_COLOR is not set.
[[nodiscard]] std::string styled(const std::string& text, Style paint);

}  // namespace rt
