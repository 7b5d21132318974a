// From a stranger's files to a worker, without a look at anything but the headers.
#pragma once

#include "common/course/process.hpp"

#include <atomic>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

namespace rt::grade {

/// A folder of nothing but what a compile may see: the project's headers, and the seats
/// (tests/grading/seat.cmake). Whoever compiles is nobody in particular, so the folders above it
/// must be open to all.
struct Workshop {
    std::filesystem::path folder;
    std::filesystem::path sealed;             ///< the launcher
    const std::atomic<bool>* stop = nullptr;  ///< once it is set, what runs is ended
};

/// What was on its way is worth nothing: somebody has stopped it.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Throws Interrupted if the workshop is stopped.
void go_on(const Workshop& workshop);

/// Fills the folder from the project and from what is built of it. Throws filesystem_error.
[[nodiscard]] Workshop open_workshop(const std::filesystem::path& project,
                                     const std::filesystem::path& build,
                                     const std::filesystem::path& folder);

/// Compiles a stage's header ahead, sealed, so that a file after it takes a third of its time.
/// Throws ProgramError.
void precompile_header(const Workshop& workshop, int stage);

/// What came of a compile or a link.
struct Made {
    bool succeeded = false;
    std::string words;  ///< why not, fit for who wrote the file
};

// Both throw ProgramError, or filesystem_error, if it is we who fail; Interrupted.

/// Compiles what was handed in for a stage. Refuses what defines symbols that are not his to
/// define.
[[nodiscard]] Made compile_submission(const Workshop& workshop, int stage, const std::string& text,
                                      const std::filesystem::path& object);

/// Links a stage's worker of the student's objects, by stage, and the references of all others.
[[nodiscard]] Made link_worker(const Workshop& workshop, int stage,
                               const std::map<int, std::filesystem::path>& objects,
                               const std::filesystem::path& worker);

/// How the stage's worker is sealed: what RAYSTEPS_LIMITS says to it.
[[nodiscard]] std::string worker_limits(int stage);

/// Runs a tool that may read these, what belongs to the tool, and what it is told to include from
/// (-isystem); and write into the folder only, which it starts in, files of so many megabytes.
[[nodiscard]] Ending run_sealed(const Workshop& workshop, const std::filesystem::path& writable,
                                const std::vector<std::filesystem::path>& readable,
                                const Command& command, int megabytes = 32);

}  // namespace rt::grade
