// A sealed process: it computes and answers, and can do nothing else. docs/instructors.md says what
// that promises.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rt::grade {

enum class Work {
    answering,  ///< a worker: no file, no process, no signal to another; one channel, threads
    building,   ///< a compiler: processes, and the files below; one process more, which watches it
};

/// What a sealed process may use up.
struct Seal {
    Work work = Work::answering;
    int cpu_seconds = 10;
    int wall_seconds = 30;  ///< of building; who asks a worker watches the clock
    int megabytes = 1024;   ///< of address space
    int file_megabytes = 0;
    int threads = 64;  ///< or processes, beside those that the user runs already
    std::vector<std::string> readable;
    std::vector<std::string> writable;
};

struct SealError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Its only channel.
inline constexpr int channel = 3;

/// Where a worker's program is open until it runs.
inline constexpr int program_descriptor = 9;

/// Where `become` leaves what standard error was, until it has become.
inline constexpr int complaints = 10;

/// The group that all builders are in that were started by root: it may enter the grader's
/// temporary folder, which nobody else may. Of a range that no system gives away.
inline constexpr unsigned builders_group = 61183;

/// The launcher's exit status if the program did not start: as timeout and env have it.
inline constexpr int not_sealed = 125;

/// Turns this process into the program, sealed. A worker keeps its channel, and reads and prints
/// nothing; a compiler keeps its output. Throws SealError if a layer that must hold does not.
[[noreturn]] void become(const Seal& seal, const std::vector<std::string>& command);

/// The seal's steps, which Layers tries one by one. Each says whether it is taken now.

/// From root to a user that no process is of, to whom the seal's writable folders are given.
[[nodiscard]] bool take_user_of_its_own(const Seal& seal);
[[nodiscard]] bool take_namespaces(Work work);
[[nodiscard]] bool limit(const Seal& seal);

}  // namespace rt::grade
