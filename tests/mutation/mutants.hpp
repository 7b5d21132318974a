// Typical slips in a source: mutants with one change each.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mutation {

struct Mutant {
    std::string source;    ///< all of it, with the change
    int line = 0;          ///< of the change
    std::string function;  ///< the function that contains it, or the constant's name
    std::string before;    ///< the changed lines as they were, on one line, without comments
    std::string after;     ///< the unchanged line
};

/// Every change to the bodies of functions and to constants that reads as another program:
/// operators exchanged, terms and factors left out, signs, numbers, components, conditions,
/// arguments, calls and assignments. Some do not compile.
[[nodiscard]] std::vector<Mutant> mutants_of(std::string_view source);

// The tokens of a C++ source, as far as mutants need them.

struct Token {
    std::string_view text;
    bool binary = false;  ///< between two spaces, as clang-format formats binary operators
    int partner = -1;     ///< for a bracket: the index of the matching one
};

/// Without comments and preprocessor's lines. They point into the source.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view source);

[[nodiscard]] bool is_name(const Token& token);
[[nodiscard]] bool is_number(const Token& token);

// Possible replacements of a token, and the tokens that end an operand.

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

// The known surviving mutants, and the reasons.

struct Survivor {
    std::string stage;
    std::string function;
    std::string before;
    std::string after;
    std::string kind;  ///< "equivalent": as right as the reference; "accuracy": only less exact
    std::string reason;
};

/// A file of blocks:
///
///     step05_triangle normal
///     - the line
///     + the changed line
///     equivalent: the reason, for all the changes above it
///
/// Throws std::runtime_error for anything else.
[[nodiscard]] std::vector<Survivor> read_survivors(const std::filesystem::path& file);

/// The one that a mutant is, or null.
[[nodiscard]] const Survivor* find(const std::vector<Survivor>& survivors, const std::string& stage,
                                   const Mutant& mutant);

}  // namespace mutation
