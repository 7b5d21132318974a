// From an untrusted submission to a worker. The compiler can read the headers, and nothing else.
#pragma once

#include "common/stages/graded_file.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <atomic>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>

namespace rt::grade {

/// A folder that contains only what a compiler may read: the project's headers, and the link kits
/// (common/course/grade/seat.cmake). The compiler runs as an unprivileged user, so all folders
/// above it must be readable by everyone.
struct BuildDirectory {
    fs::path folder;
    fs::path sealed;                          ///< the launcher
    const std::atomic<bool>* stop = nullptr;  ///< when this becomes true, running programs are
                                              ///< stopped
};

/// The work was stopped; its partial result must not be used.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Throws Interrupted if the workshop is stopped.
void go_on(const BuildDirectory& workshop);

/// Throws InputError if the folder is on a disk from which no program may be run.
void check_executable(const fs::path& folder);

/// Space on a disk for the files of a few tools at a time, in bytes.
constexpr std::uintmax_t space_of_tools = 64 << 20;

/// Throws InputError if the disk of the folder is full, or nearly: a tool that failed there may
/// have failed for no fault of the submission. A disk that reports no size does not count as full.
void check_space(const fs::path& folder, std::uintmax_t least = space_of_tools);

/// Fills the folder from the project and its build. Throws filesystem_error, or InputError if the
/// disk is full.
[[nodiscard]] BuildDirectory open_workshop(const fs::path& project, const fs::path& build,
                                           const fs::path& folder);

/// The result of a compile or a link.
struct Build {
    bool succeeded = false;
    std::string words;  ///< the reason for a failure, for the author of the file
};

/// " was ended by the clock …": the reason why a program that computed for less than its limit is
/// no submission's fault.
[[nodiscard]] std::string ended_by_the_clock(const ProcessResult& ending);

// Both functions throw ProgramError, InputError or filesystem_error if the grader itself fails, and
// Interrupted.

/// Compiles a file of a submission. Refuses one that defines symbols other than its own.
[[nodiscard]] Build compile_submission(const BuildDirectory& workshop, GradedFile graded,
                                       const std::string& text, const fs::path& object);

/// Links a stage's worker from the student's objects, and the references of all other files.
[[nodiscard]] Build link_worker(const BuildDirectory& workshop, int stage,
                                const std::map<GradedFile, fs::path>& objects,
                                const fs::path& worker);

/// The sandbox of the stage's worker: the value of RAYSTEPS_LIMITS.
[[nodiscard]] std::string worker_limits(int stage);

/// The limits of a tool: of the size of each file that it writes, of its processor time, and of its
/// time by the clock on an idle machine.
struct ToolLimits {
    int megabytes = 32;
    int processor_seconds = 15;
    int wall_seconds = 20;
};

/// Runs a tool in the sandbox. It may read these files and the system's tools and headers, and
/// write only to its working folder. Its standard input is the file `input`, if there is one, which
/// no other user need be able to read. Throws InputError if it fails on a full disk, and
/// ProgramError if the clock ends it though it has computed for less than half of its processor
/// time: then the machine is at fault, and not the submission.
[[nodiscard]] ProcessResult run_sealed(const BuildDirectory& workshop, const fs::path& writable,
                                       const std::vector<fs::path>& readable,
                                       const Command& command, const ToolLimits& limits = {},
                                       const fs::path& input = {});

}  // namespace rt::grade
