// `./course own`: the frame of a ray tracer outside the project, made of the student's stages.
#pragma once

#include <filesystem>
#include <string>

namespace rt {

/// Writes a new folder with the student's files of all started stages of the project, except their
/// main.cpp, the headers that these files include, an almost empty main.cpp, a CMakeLists.txt and a
/// README.md. Prints which stages are left out, and warns of includes that the contracts of the
/// stages do not lead to. The folder appears complete or not at all. Throws InputError if it exists
/// and is not empty, or if no stage is started. Returns 0.
int lay_out_own(const std::filesystem::path& project, const std::filesystem::path& destination);

/// The shell command that builds the program in the folder. With Ninja, since `./course` installs
/// it and not make, CMake's default.
[[nodiscard]] std::string own_build_command(const std::filesystem::path& folder);

}  // namespace rt
