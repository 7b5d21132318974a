// The client of a worker process, and the reasons why an answer may be missing.
//
// RAYSTEPS_SEALED   the launcher `sealed`, if the process runs in the sandbox
// RAYSTEPS_LIMITS   its limits, in the launcher's form: "cpu=10 memory=512"
#pragma once

#include <sys/types.h>

#include <chrono>
#include <ctime>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rt::contract {

/// There is no answer, and there will be none. The message is the reason as a clause: "crashed:
/// Segmentation fault".
struct NoAnswer : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// There is no such program.
struct CannotStart : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The seconds that a process spends computing or sleeping. Time spent waiting for a busy processor
/// does not count.
class Stopwatch {
public:
    Stopwatch() = default;
    explicit Stopwatch(pid_t process);

    /// Starts the wait for an answer: sleep counts only from here on. Returns what was used before.
    double waits();

    /// Until now, or until it was last there.
    [[nodiscard]] double computed();
    [[nodiscard]] double used() { return computed() + slept_; }

    /// Counts the time since the last call as sleep, if the process is asleep now: a tenth of a
    /// second at most, as Countdown does. Call it several times a second.
    void look();
    [[nodiscard]] bool is_due() const;

private:
    using Clock = std::chrono::steady_clock;

    pid_t process_ = 0;
    std::optional<clockid_t> clock_;  ///< of its computing time
    double computed_ = 0;
    double slept_ = 0;
    double computed_when_looked_ = 0;
    Clock::time_point looked_ = Clock::now();
};

/// A worker program, started.
class Worker {
public:
    /// Throws CannotStart.
    explicit Worker(const std::string& program);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// The bytes of the answer. Throws NoAnswer if the worker uses more than these seconds for it,
    /// or more than `most` for all answers, by the stopwatch, and then the process has been ended;
    /// or if the function has thrown an exception.
    [[nodiscard]] std::string ask(const std::string& question, double seconds,
                                  double most = std::numeric_limits<double>::infinity());

    /// Since it was started, whether it is still there or not.
    [[nodiscard]] double used() { return stopwatch_.used(); }

    [[nodiscard]] bool alive() const { return process_ > 0; }

private:
    /// The allowance for an answer: seconds, and the end on the stopwatch.
    struct Allowance {
        double seconds;
        double until;
    };

    /// The bytes that the call, send() or recv() with these flags, has transferred: at least one.
    /// Waits for the worker within its allowance.
    template <class Call>
    std::size_t transfer(Call call, Allowance allowance);
    void send(std::string_view bytes, Allowance allowance);
    /// Reads the available bytes, at most `most`.
    std::size_t receive(char* to, std::size_t most, Allowance allowance);
    /// Ends the process, and throws NoAnswer for the reason.
    [[noreturn]] void give_up(const std::string& reason);
    [[noreturn]] void it_has_ended();
    int end();

    pid_t process_ = 0;
    int socket_ = -1;
    Stopwatch stopwatch_;
    std::mt19937_64 tickets_;
};

}  // namespace rt::contract
