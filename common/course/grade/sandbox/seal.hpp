// A sealed process: it can compute and answer, and do nothing else. docs/reference/grading.md
// lists the guarantees.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rt::grade {

enum class Work {
    answering,  ///< a worker: no file, no process, no signal to others; one channel, threads
    building,   ///< a compiler: processes, and the files below; one more process watches it
};

/// The resource limits of a sealed process.
struct Sandbox {
    Work work = Work::answering;
    int cpu_seconds = 10;
    int wall_seconds = 30;  ///< for building; the wall-clock time of a worker is limited by its
                            ///< client
    int megabytes = 1024;   ///< of address space
    int file_megabytes = 0;
    int threads = 64;  ///< or processes, beside those that the user already runs
    std::vector<std::string> readable;
    std::vector<std::string> writable;
    std::string input;  ///< a file that becomes the standard input; empty for none
};

struct SealError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The descriptor of its only channel.
inline constexpr int channel = 3;

/// The descriptor of the program's file until it starts.
inline constexpr int program_descriptor = 9;

/// The descriptor where `become` keeps the original standard error until the program starts.
inline constexpr int complaints = 10;

/// The group of all builders that root starts: only this group may enter the grader's temporary
/// folder. Its number is in a range that no system assigns.
inline constexpr unsigned builders_group = 61183;

/// The launcher's exit status if the program did not start, the same as that of timeout and env.
inline constexpr int not_sealed = 125;

/// Replaces this process by the program, sealed. A worker keeps its channel, and has no input or
/// output; a compiler keeps its output. Throws SealError if a required layer does not work.
[[noreturn]] void become(const Sandbox& seal, const std::vector<std::string>& command);

/// The steps of the sandbox, which Layers tries one by one. Each returns true if it succeeded.

/// Switches from root to a user without other processes, who becomes the owner of the sandbox's
/// writable folders.
[[nodiscard]] bool take_user_of_its_own(const Sandbox& seal);
[[nodiscard]] bool take_namespaces(Work work);
[[nodiscard]] bool limit(const Sandbox& seal);

/// The expected ratio of wall-clock time to run time on an idle machine: runnable processes per
/// processor in the last minute, clamped to 1 to 15. Wall-clock limits are multiplied by it.
[[nodiscard]] double busy();

/// Installs the filter of system calls (seccomp_filter.cpp) permanently on this process and its
/// children. Workers and compilers have one list of allowed calls each. A worker gets an error for
/// calls that honest code may try without harm (to open a file), and is killed for any other; a
/// compiler gets ENOSYS for every call not on the list. Returns true if the filter is active.
[[nodiscard]] bool filter_system_calls(const Sandbox& seal);

}  // namespace rt::grade
