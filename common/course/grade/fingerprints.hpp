// What stays of a C++ file when its comments, names, numbers and layout are taken away.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::grade {

/// The file's tokens, a character each: every name is "n", every number "0", every text "t", the
/// words of control flow a capital each. Braces, const, namespaces and #-lines are left out.
[[nodiscard]] std::string normalised(std::string_view source);

/// Hashes of some of the passages of 16 tokens, in order, each once: of any 23 tokens that two
/// files share, both have one (Schleimer, Wilkerson and Aiken's winnowing).
[[nodiscard]] std::vector<std::uint64_t> fingerprints(const std::string& tokens);

/// The hashes of all passages, in order, each once.
[[nodiscard]] std::vector<std::uint64_t> passages(const std::string& tokens);

}  // namespace rt::grade
