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
    int threads = 64;        ///< or processes, where they can be counted: see Layers
    bool libraries = false;  ///< a worker that is linked to shared libraries
    std::vector<std::string> readable;
    std::vector<std::string> writable;
};

struct SealError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Its only channel.
inline constexpr int channel = 3;

/// Where `become` leaves what standard error was, until it has become.
inline constexpr int complaints = 10;

/// The user that a process becomes which was started by root: of a range that no system gives away.
[[nodiscard]] unsigned user_of_its_own();

/// The launcher's exit status if the program did not start: as timeout and env have it.
inline constexpr int not_sealed = 125;

/// Turns this process into the program, sealed. A worker keeps its channel, and reads and prints
/// nothing; a compiler keeps its output. Throws SealError if a layer that must hold does not.
[[noreturn]] void become(const Seal& seal, const std::vector<std::string>& command);

/// The seal's steps, which Layers tries one by one. Each says whether it is taken now.
[[nodiscard]] bool take_user_of_its_own();
[[nodiscard]] bool take_namespaces(Work work);
[[nodiscard]] bool limit(const Seal& seal, bool processes_are_counted);

}  // namespace rt::grade
