// The tokens of a C++ source, as far as mutants need them.
#pragma once

#include <string_view>
#include <vector>

namespace mutation {

struct Token {
    std::string_view text;
    bool binary = false;  ///< between two spaces, as clang-format formats binary operators
    int partner = -1;     ///< for a bracket: the index of the matching one
};

/// Without comments and preprocessor's lines. They point into the source.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view source);

[[nodiscard]] bool is_name(const Token& token);
[[nodiscard]] bool is_number(const Token& token);

}  // namespace mutation
