// The load of the machine.
#pragma once

namespace rt::grade {

/// The expected ratio of wall-clock time to run time on an idle machine: runnable processes per
/// processor in the last minute, clamped to 1 to 15. Wall-clock limits are multiplied by it.
[[nodiscard]] double busy();

}  // namespace rt::grade
