// Building, quietly.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// What came of a build.
struct Build {
    bool succeeded = false;
    std::string output;  ///< what the compiler and the linker said: errors, or warnings
};

/// Builds the targets in the build folder, everything if there are none. On a terminal it shows how
/// far it is.
[[nodiscard]] Build try_build(const std::vector<std::string>& targets);

/// The same. Throws ProgramError if it fails, with the first error as compiler_errors.hpp tells it.
void build(const std::vector<std::string>& targets);

/// Stages that are built from the reference though a student's file exists, from now on: "3;5".
/// Throws ProgramError if CMake fails.
void choose_reference(const std::string& stages);

}  // namespace rt
