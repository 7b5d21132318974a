// Copies of the project's main.cpp, which is in every hand-out.
#pragma once

#include <string_view>

namespace rt::grade {

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
