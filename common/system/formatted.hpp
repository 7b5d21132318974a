// Numbers in a text.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace rt {

/// The text that std::printf writes, of at most 511 bytes.
template <class... Values>
[[nodiscard]] std::string formatted(const char* format, Values... values) {
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

}  // namespace rt
