// What may stand in the place of a token, and which tokens end an operand.
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

/// How strongly an operator binds; 0 of what is none, or binds less than any that is exchanged.
[[nodiscard]] int binding(const Token& token);

/// Whether no operand goes on beyond it, at either end.
[[nodiscard]] bool ends_operand(const Token& token);

[[nodiscard]] bool opens(const Token& token);
[[nodiscard]] bool closes(const Token& token);

}  // namespace mutation
