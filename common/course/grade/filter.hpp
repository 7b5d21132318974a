// Which system calls are let through (seccomp).
#pragma once

#include "common/course/grade/seal.hpp"

namespace rt::grade {

/// Puts the filter on this process and on all that come of it, for good. Either has a list of what
/// it may do. Beyond it a worker is refused what honest code tries without harm (to open a file)
/// and is ended by anything else; to a compiler the kernel seems to have no such call. Returns
/// whether the filter is on.
[[nodiscard]] bool filter_system_calls(const Seal& seal);

}  // namespace rt::grade
