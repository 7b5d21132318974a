// Processes whose parent has ended, such as those that a student's code forks and leaves running.
#pragma once

#include <sys/types.h>

#include <set>

namespace rt {

/// While it lives, the processes that programs leave running become children of this process, on
/// Linux. The destructor ends them. Programs that this process has started, and what was its child
/// before, go on. On other systems nothing is ended.
class Orphans {
public:
    Orphans();
    ~Orphans();
    Orphans(const Orphans&) = delete;
    Orphans& operator=(const Orphans&) = delete;

private:
    std::set<pid_t> before_;
};

/// Notes that this process has started a program. The caller has held `inheritance`
/// (descriptors.hpp) since before the fork.
void note_start(pid_t process);

/// Notes that a program has ended.
void note_end(pid_t process);

}  // namespace rt
