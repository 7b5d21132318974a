// The ending of a file's name: ".tar.gz".
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace rt {

/// The first of these endings that the name has; nothing if it has none, or is an ending alone.
template <std::size_t Count>
[[nodiscard]] std::string_view ending_of(const std::string& name,
                                         const std::array<std::string_view, Count>& endings) {
    for (const std::string_view ending : endings)
        if (name.size() > ending.size() && name.ends_with(ending)) return ending;
    return {};
}

}  // namespace rt
