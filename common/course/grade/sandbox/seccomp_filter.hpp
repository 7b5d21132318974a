// The filter of system calls (seccomp).
#pragma once

#include "common/course/grade/sandbox/seal.hpp"

namespace rt::grade {

/// Installs the filter permanently on this process and its children. Workers and compilers have one
/// list of allowed calls each. A worker gets an error for calls that honest code may try without
/// harm (to open a file), and is killed for any other; a compiler gets ENOSYS for every call not on
/// the list. Returns true if the filter is active.
[[nodiscard]] bool filter_system_calls(const Sandbox& seal);

}  // namespace rt::grade
