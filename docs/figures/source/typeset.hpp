// Labels with the course's mathematical notation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt::figures {

/// Text in one position and one slant.
struct Run {
    std::string text;
    bool italic = false;
    int script = 0;  ///< −1 below the line, +1 above it
};

/// The label cut into runs. Between two $, "_" lowers and "^" raises the next letter or {group},
/// and a single letter is italic: "$o_r$", "$t_{min}$ > 0".
[[nodiscard]] std::vector<Run> typeset(std::string_view label);

/// The text with the special characters of XML as entities.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace rt::figures
