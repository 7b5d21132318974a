// What a graded file may include of the project.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace rt {

/// The header that a stage's file implements: "steps/step05_triangle/triangle.hpp".
[[nodiscard]] std::filesystem::path stage_header(int stage);

/// The headers that are there when a file of the stage is graded, by their paths in the project:
/// the stage's own, those that steps/may_include.txt lists, and what these include. Throws
/// InputError if one cannot be read.
[[nodiscard]] std::set<std::filesystem::path> allowed_headers(const std::filesystem::path& project,
                                                              int stage);

/// A line of a file, and what it includes.
struct Include {
    int line = 0;
    std::string header;  ///< as the file spells it
};

/// What a student's file includes of the project, or of the folder that it is in, and is not there
/// when it is graded. Its text decides: an #include after `#if 0` counts too. Throws InputError.
[[nodiscard]] std::vector<Include> refused_includes(const std::filesystem::path& project, int stage,
                                                    const std::filesystem::path& file);

}  // namespace rt
