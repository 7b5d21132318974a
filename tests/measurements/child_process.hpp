// Child processes and their cost. POSIX: students' builds do not need it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace measurements {

struct Usage {
    double cpu = 0;   ///< seconds of all its threads, the system's share too
    double wall = 0;  ///< seconds
};

/// Runs a program to its end and returns the cost of all of it; its output is discarded. Throws
/// std::runtime_error if it cannot be run or fails.
[[nodiscard]] Usage run(const std::vector<std::string>& words);

/// Calls the work in a separate process, so that it starts with nothing built and nothing cached,
/// and returns the cost of each step: a step ends when the work calls its argument. Throws
/// std::runtime_error if the work throws, or ends in another way.
[[nodiscard]] std::vector<Usage> run_apart(
    const std::function<void(const std::function<void()>& step_done)>& work);

}  // namespace measurements
