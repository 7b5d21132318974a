// A known word that is similar to a mistyped one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

/// The number of letters to insert, remove or replace, or of neighbors to exchange, until the two
/// words are equal.
[[nodiscard]] std::size_t edits(const std::string& a, const std::string& b);

/// " Did you mean X?" for the most similar of the known words, whatever their case: it begins with
/// the word, or at most a third of the letters differ. Empty if there is none.
[[nodiscard]] std::string suggestion(const std::string& word,
                                     const std::vector<std::string>& known);

}  // namespace rt
