// The paths of the project: its folder, the build, and the files of each stage.
#pragma once

#include "common/stages/stages.hpp"
#include "common/system/files.hpp"

#include <string>

namespace rt {

extern const fs::path project_folder;
extern const fs::path build_folder;

/// True if OpenMesh is installed; without it, stage 13 is left out of the build.
extern const bool has_meshes;

/// True if Boost is installed; without it, nothing is measured against exact arithmetic.
extern const bool has_oracle;

/// The language of the environment, if the project has a folder for it in lang/; else empty.
[[nodiscard]] std::string project_language();

/// Reads the translations lang/LANGUAGE/NAME.po, in the language of the environment.
void read_project_translations(const std::string& name);

/// A path relative to the project's folder, such as "steps/step05_triangle/student".
[[nodiscard]] inline std::string step_path(int stage, const std::string& rest) {
    return "steps/" + name_of(stage) + "/" + rest;
}

/// False if this is a hand-out that leaves out the stage: it has no starter.
[[nodiscard]] inline bool is_here(int stage) {
    return fs::exists(project_folder / step_path(stage, "starter"));
}

/// A program or test of the stage: "step05_triangle" + suffix.
[[nodiscard]] inline std::string stage_target(int stage, const std::string& suffix = "") {
    return name_of(stage) + suffix;
}

/// The student's loop over the pixels, in stage 1, or `trace`, from stage 3 on, in
/// steps/stepNN_name/student/: in the stage's program it replaces the main.cpp in the folder above.
/// The other files have the functions of the contract.
constexpr const char* trace_file = "main.cpp";

}  // namespace rt
