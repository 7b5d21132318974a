// Where things are: the project's folder, what is built, and the files of each stage.
#pragma once

#include "common/stages.hpp"

#include <filesystem>
#include <string>

namespace rt {

extern const std::filesystem::path project_folder;
extern const std::filesystem::path build_folder;

/// Whether OpenMesh is there, without which stage 13 is left out of the build.
extern const bool has_meshes;

/// Whether Boost is there, without which nothing is measured against exact arithmetic.
extern const bool has_oracle;

/// "steps/step05_triangle/student", say: what somebody sees who stands in the project's folder.
[[nodiscard]] inline std::string step_path(int stage, const std::string& rest) {
    return "steps/" + std::string(stage_name(stage)) + "/" + rest;
}

/// A program or test of the stage: "step05_triangle" + suffix.
[[nodiscard]] inline std::string stage_target(int stage, const std::string& suffix = "") {
    return std::string(stage_name(stage)) + suffix;
}

}  // namespace rt
