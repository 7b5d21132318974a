// SHA-256 (FIPS 180-4), which identifies a file by its content: no two texts with the same hash are
// known.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

/// The text's SHA-256, as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view text);

/// The hash of several texts in their order. It depends on the boundaries between the texts too.
template <class... Texts>
[[nodiscard]] std::string sha256_of_all(const Texts&... texts) {
    return sha256((sha256(texts) + ...));
}

}  // namespace rt::grade
