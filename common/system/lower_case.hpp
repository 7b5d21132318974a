// Letters without case, of ASCII alone: names of files, keywords.
#pragma once

#include <string>

namespace rt {

/// The text with ASCII letters in lower case.
[[nodiscard]] inline std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

}  // namespace rt
