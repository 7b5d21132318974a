// Processes and what they cost. POSIX: nothing a student builds needs it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace measurements {

struct Usage {
    double cpu = 0;   ///< seconds of all its threads, the system's share too
    double wall = 0;  ///< seconds
};

/// Runs a program to its end and says what all of it took; what it prints is thrown away. Throws
/// std::runtime_error if it cannot be run or fails.
[[nodiscard]] Usage run(const std::vector<std::string>& words);

/// Calls the work in a process of its own, so that it starts with nothing built and nothing cached,
/// and says what each step of it took: a step ends where the work calls its argument. Throws
/// std::runtime_error if the work does, or ends in another way.
[[nodiscard]] std::vector<Usage> run_apart(
    const std::function<void(const std::function<void()>& step_done)>& work);

}  // namespace measurements
