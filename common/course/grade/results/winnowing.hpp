// The structure of a C++ file, without its comments, names, numbers and layout.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::grade {

/// The file's tokens, one character each: a name is "n", a number "0", a text "t", each
/// control-flow keyword a capital letter. Left out are what may be there or not: braces, const,
/// return, empty parentheses, the captures of a lambda, namespaces, and preprocessor lines but for
/// the text of a #define.
[[nodiscard]] std::string normalized(std::string_view source);

/// The normalized text without a statement that is a third of all: one put after every other.
[[nodiscard]] std::string without_fillers(const std::string& tokens);

/// Hashes of some of the passages of 16 tokens, sorted and without duplicates: two files that share
/// any 23 tokens share at least one hash (winnowing: Schleimer, Wilkerson and Aiken).
[[nodiscard]] std::vector<std::uint64_t> fingerprints(const std::string& tokens);

/// The hashes of all passages, sorted and without duplicates.
[[nodiscard]] std::vector<std::uint64_t> passages(const std::string& tokens);

}  // namespace rt::grade
