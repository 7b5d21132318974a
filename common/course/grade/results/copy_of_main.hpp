// Copies of the project's main.cpp, which is in every hand-out.
#pragma once

#include <string_view>

namespace rt::grade {

/// The message on a file that differs from the project's by comments, names or layout.
inline constexpr const char* copied_main =
    "main.cpp is a copy of the project's own, apart from comments, names and layout: it is not "
    "graded.";

/// True if the text is that of the project's main.cpp, apart from comments, names, layout and
/// includes. A stage's starter may lack so little of it that a student's own answer has no other
/// form (a line, in stages 4 to 8): there, a copy has the project's comments, too.
[[nodiscard]] bool is_copy_of_main(std::string_view text, std::string_view projects,
                                   std::string_view starter);

}  // namespace rt::grade
