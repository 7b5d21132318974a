// The files that a student hands in for a stage.
#pragma once

#include "common/stages/stages.hpp"

#include <compare>
#include <vector>

namespace rt {

/// True if a stage has a main.cpp that the student writes: with the loop over the pixels in stage
/// 1, with `trace` from stage 3 on.
[[nodiscard]] constexpr bool has_trace(int stage) {
    return stage == 1 || stage >= shapes_stage;
}

/// The file of a stage's functions, or its main.cpp, which is called its trace in stage 1, too.
/// Each has a suite of its own.
struct GradedFile {
    int stage = 1;
    bool is_trace = false;

    constexpr GradedFile() = default;
    // NOLINTNEXTLINE: the number of a stage means its functions
    constexpr GradedFile(int of_stage, bool of_trace = false)
        : stage(of_stage), is_trace(of_trace) {}
    auto operator<=>(const GradedFile&) const = default;
};

/// "step03_sphere", "step03_sphere_trace": as in the names of suites and link kits.
[[nodiscard]] inline std::string name_of(GradedFile file) {
    return name_of(file.stage) + (file.is_trace ? "_trace" : "");
}

[[nodiscard]] inline std::vector<GradedFile> files_of(int stage) {
    std::vector<GradedFile> files{GradedFile(stage)};
    if (has_trace(stage)) files.emplace_back(stage, true);
    return files;
}

/// The student's name for it: "sphere.cpp", "main.cpp".
[[nodiscard]] inline std::string file_name(GradedFile file) {
    return file.is_trace ? "main.cpp" : topic_of(file.stage) + ".cpp";
}

/// A name that no other file of a submission has: "sphere.cpp", "sphere_main.cpp".
[[nodiscard]] inline std::string submitted_name(GradedFile file) {
    return topic_of(file.stage) + (file.is_trace ? "_main.cpp" : ".cpp");
}

}  // namespace rt
