// From a stranger's file to a worker, without a look at anything but the headers.
#pragma once

#include "common/course/process.hpp"

#include <filesystem>
#include <string>

namespace rt::grade {

/// A folder of nothing but what a compile may see: the project's headers, and the seats. Whoever
/// compiles is nobody in particular, so the folders above it must be open to all.
struct Workshop {
    std::filesystem::path folder;
    std::filesystem::path sealed;  ///< the launcher
};

/// Fills the folder from the project and from what is built of it. Throws filesystem_error.
[[nodiscard]] Workshop open_workshop(const std::filesystem::path& project,
                                     const std::filesystem::path& build,
                                     const std::filesystem::path& folder);

struct Compiled {
    bool made = false;
    std::string words;       ///< why not; or what the compiler warned of
    bool libraries = false;  ///< the worker is sealed with "libraries=1"
};

/// Makes the worker of a stage from a file: seat is "step03_sphere_f64". Whatever is wrong with
/// the file is told in the words. Throws ProgramError, or filesystem_error, if it is we who fail.
[[nodiscard]] Compiled compile_submission(const Workshop& workshop, const std::string& seat,
                                          const std::filesystem::path& file,
                                          const std::filesystem::path& worker);

}  // namespace rt::grade
