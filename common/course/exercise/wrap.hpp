// Long lines on narrow terminals.
#pragma once

#include <string>

namespace rt {

/// The line, broken after commas outside of quoted texts, so that it stays C++ and can be pasted.
/// Continued lines are indented by four more. A part without such a comma stays longer.
[[nodiscard]] std::string wrapped(const std::string& line, int columns);

/// The same for the width of the terminal; the line itself if the standard output is none.
[[nodiscard]] std::string wrapped(const std::string& line);

}  // namespace rt
