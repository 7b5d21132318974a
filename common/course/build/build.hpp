// Quiet builds.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rt {

/// The result of a build.
struct Build {
    bool succeeded = false;
    std::string output;  ///< output of the compiler and the linker: errors or warnings
};

/// Builds the targets in the build folder, or everything if the list is empty. Shows the progress
/// on a terminal. Calls `done` after each edge, with its description; meanwhile the build goes on,
/// and after an error too, with what does not need the failed edge.
[[nodiscard]] Build try_build(const std::vector<std::string>& targets,
                              const std::function<void(const std::string& edge)>& done = {});

/// The same, but throws ProgramError if the build fails, with the first error in the form of
/// compiler_errors.hpp.
void build(const std::vector<std::string>& targets);

/// From now on, builds these stages ("3;5") from the reference even if a student's file exists.
/// Throws ProgramError if CMake fails.
void choose_reference(const std::string& stages);

}  // namespace rt
