// Which layers of the seal hold on this machine.
#pragma once

#include <string>
#include <vector>

namespace rt::grade {

struct Layer {
    std::string name;
    bool holds = false;
    bool needed = false;  ///< without it nothing is graded
};

/// Found by trying each on a process of its own, from the strongest to the least.
[[nodiscard]] std::vector<Layer> layers();

/// Whether all that is needed holds.
[[nodiscard]] bool hold(const std::vector<Layer>& layers);

/// A line for each, to be printed: "✓ system calls are filtered (seccomp)".
[[nodiscard]] std::string text_of(const std::vector<Layer>& layers);

}  // namespace rt::grade
