// The layers of the sandbox that work on this machine.
#pragma once

#include <string>
#include <vector>

namespace rt::grade {

struct Layer {
    std::string name;
    bool holds = false;
    bool needed = false;  ///< nothing is graded without it
};

/// Tries each layer in a process of its own, from the strongest to the weakest.
[[nodiscard]] std::vector<Layer> layers();

/// True if all needed layers work.
[[nodiscard]] bool hold(const std::vector<Layer>& layers);

}  // namespace rt::grade
