// Options that are a pair of numbers: a size, a pixel, a part of a class.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rt {

/// Parses two integers with `separator` between them and nothing around them.
[[nodiscard]] std::optional<std::array<int, 2>> two_numbers(std::string_view text, char separator);

}  // namespace rt
