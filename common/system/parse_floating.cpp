#include "common/system/parse_floating.hpp"

#include <charconv>

namespace rt {

std::optional<std::array<int, 2>> two_numbers(std::string_view text, char separator) {
    std::array<int, 2> numbers{};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, numbers[0]);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != separator) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, numbers[1]);
    if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
    return numbers;
}

}  // namespace rt
