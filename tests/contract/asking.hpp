// The asking end: another process that answers, and what became of it.
//
// RAYSTEPS_SEALED   the launcher `sealed`, if the process is to be sealed
// RAYSTEPS_LIMITS   what it may use up, as the launcher has it: "cpu=10 memory=512"
#pragma once

#include <sys/types.h>

#include <chrono>
#include <random>
#include <stdexcept>
#include <string>

namespace rt::contract {

/// No answer came, and none will: says why in half a sentence, "crashed: Segmentation fault".
struct NoAnswer : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// There is no such program.
struct CannotStart : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A worker program, started.
class Worker {
public:
    /// Throws CannotStart.
    explicit Worker(const std::string& program);
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// The bytes of the answer. Throws NoAnswer if there is none within the time, and then the
    /// process has been ended; or if the function has thrown an exception.
    [[nodiscard]] std::string ask(const std::string& question, double seconds);

    [[nodiscard]] bool alive() const { return process_ > 0; }

private:
    using Clock = std::chrono::steady_clock;

    void wait_until_ready(short event, Clock::time_point deadline, double seconds);
    void send(const char* from, std::size_t count, Clock::time_point deadline, double seconds);
    void receive(char* to, std::size_t count, Clock::time_point deadline, double seconds);
    /// Ends the process, and throws NoAnswer for the reason.
    [[noreturn]] void give_up(const std::string& reason);
    [[noreturn]] void it_has_ended();
    int end();

    pid_t process_ = 0;
    int socket_ = -1;
    std::mt19937_64 tickets_;
};

}  // namespace rt::contract
