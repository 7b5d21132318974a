// The structure of a C++ file, without its comments, names, numbers and layout, and copies of the
// project's main.cpp, which is in every hand-out.
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

/// The message on a file that differs from the project's by comments, names or layout.
inline constexpr const char* copied_main =
    "main.cpp is a copy of the project's own, apart from comments, names and layout: it is not "
    "graded.";

/// The least percentage at which a file is reported as like the project's. Independent right
/// answers (tests/alternatives) reach 84; the project's own without some lines, or with a helper
/// declared before, reaches more.
inline constexpr int like_main_percent = 85;

/// The percentage of the longer text that is in both, in order, apart from comments, names and
/// layout; 0 if the stage's starter contains most of the project's.
[[nodiscard]] int percent_of_main(std::string_view text, std::string_view projects,
                                  std::string_view starter);

/// True if the text is that of the project's main.cpp, apart from comments, names, layout and
/// includes. A stage's starter may lack so little of it that a student's own answer has no other
/// form (a line, in stages 4 to 8): there, a copy has the project's comments, too.
[[nodiscard]] bool is_copy_of_main(std::string_view text, std::string_view projects,
                                   std::string_view starter);

}  // namespace rt::grade
