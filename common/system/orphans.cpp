#include "common/system/orphans.hpp"

#include "common/system/descriptors.hpp"

#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <mutex>

namespace rt {

namespace {

// Guarded by `inheritance`.
std::set<pid_t> started;
int living = 0;  ///< objects of Orphans

/// Sets whether orphans become children of this process.
void adopt([[maybe_unused]] bool orphans) {
#ifdef __linux__
    prctl(PR_SET_CHILD_SUBREAPER, orphans ? 1 : 0);
#endif
}

/// The children of this process: an orphan may be any thread's. Empty where the system has no such
/// files.
std::set<pid_t> children() {
    std::set<pid_t> all;
    std::error_code none;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", none)) {
        std::ifstream list(thread.path() / "children");
        for (pid_t child = 0; list >> child;) all.insert(child);
    }
    return all;
}

}  // namespace

Orphans::Orphans() {
    const std::scoped_lock lock(inheritance);
    if (living++ == 0) adopt(true);
    before_ = children();
}

Orphans::~Orphans() {
    const std::scoped_lock lock(inheritance);
    // The children of one that is ended are orphans, too. The number of rounds is limited, since a
    // process that forks without end may be faster.
    constexpr int rounds = 100;
    bool found = true;
    for (int i = 0; found && i < rounds; ++i) {
        found = false;
        for (const pid_t child : children()) {
            if (before_.contains(child) || started.contains(child)) continue;
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
            found = true;
        }
    }
    if (--living == 0) adopt(false);  // the linker's, say, are no business of this process
}

void note_start(pid_t process) {
    started.insert(process);
}

void note_end(pid_t process) {
    const std::scoped_lock lock(inheritance);
    started.erase(process);
}

}  // namespace rt
