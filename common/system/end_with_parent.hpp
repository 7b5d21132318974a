// The end of a process whose parent is gone.
#pragma once

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace rt {

/// From now on this process gets the signal when its parent ends. Only Linux can send it: elsewhere
/// a process notices the end of its parent when it reads or writes.
inline void end_with_parent([[maybe_unused]] int signal) {
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, signal);
#endif
}

}  // namespace rt
