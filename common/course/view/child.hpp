// A program that can be given up.
#pragma once

#include "common/course/process.hpp"

#include <atomic>
#include <chrono>

namespace rt {

/// listen_to, which also ends as soon as `cancelled` is set. What the program started ends with it.
[[nodiscard]] Ending listen_until(const std::atomic<bool>& cancelled, const Command& command,
                                  std::chrono::milliseconds limit);

}  // namespace rt
