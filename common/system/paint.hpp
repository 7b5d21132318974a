// Color on a terminal.
#pragma once

#include <string>

namespace rt {

enum class Style { good, bad, bold, dim };

/// The text in color, if the standard output is a terminal that is not "dumb", or CLICOLOR_FORCE is
/// set to something but 0; never if NO_COLOR is set.
[[nodiscard]] std::string styled(const std::string& text, Style paint);

}  // namespace rt
