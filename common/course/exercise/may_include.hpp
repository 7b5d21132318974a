// The project's headers that a graded file may include.
#pragma once

#include "common/stages/graded_file.hpp"
#include "common/system/files.hpp"

#include <set>
#include <string>
#include <vector>

namespace rt {

/// The header that a stage's file implements: "steps/step05_triangle/triangle.hpp".
[[nodiscard]] fs::path stage_header(int stage);

/// The headers that exist when a file is graded, as paths in the project: the stage's own (of a
/// main.cpp, those of earlier stages too), those listed in steps/may_include.txt, and all headers
/// that these include. Throws InputError if one cannot be read.
[[nodiscard]] std::set<fs::path> allowed_headers(const fs::path& project, GradedFile graded);

/// One #include of a file.
struct Include {
    int line = 0;
    std::string header;  ///< as spelled in the file
};

/// All includes of a file, in quotes or in brackets. Conditions are not evaluated, so that an
/// #include in an inactive part is returned too; one in a comment is not. Throws InputError if it
/// cannot be read.
[[nodiscard]] std::vector<Include> includes_of(const fs::path& file);

/// The includes of a student's file, of the project or of its own folder, that are missing when it
/// is graded. Throws InputError.
[[nodiscard]] std::vector<Include> refused_includes(const fs::path& project, GradedFile graded,
                                                    const fs::path& file);

}  // namespace rt
