// Possible replacements of a token, and the tokens that end an operand.
#pragma once

#include "tests/mutation/tokens.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mutation {

using Words = std::vector<std::string_view>;

[[nodiscard]] bool among(std::string_view text, const Words& words);

[[nodiscard]] const Words& instead_of_operator(std::string_view text);
[[nodiscard]] const Words& instead_of_name(std::string_view text);
[[nodiscard]] std::vector<std::string> instead_of_number(std::string_view text);

/// Operator precedence; 0 for anything that is not a mutated operator, or binds less than all of
/// them.
[[nodiscard]] int binding(const Token& token);

/// True if no operand extends past this token, in either direction.
[[nodiscard]] bool ends_operand(const Token& token);

[[nodiscard]] bool opens(const Token& token);
[[nodiscard]] bool closes(const Token& token);

}  // namespace mutation
