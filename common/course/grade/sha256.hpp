// A file is known by its content: two texts with one SHA-256 are not known to anybody (FIPS 180-4).
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

/// The text's SHA-256, as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view text);

/// Of several texts in their order: what is cut elsewhere has another SHA-256.
template <class... Texts>
[[nodiscard]] std::string sha256_of_all(const Texts&... texts) {
    return sha256((sha256(texts) + ...));
}

}  // namespace rt::grade
