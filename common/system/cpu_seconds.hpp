// The clock of trials and measurements.
#pragma once

#include <ctime>

namespace rt {

/// The processor time of this program so far, of all its threads together.
[[nodiscard]] inline double cpu_seconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace rt
