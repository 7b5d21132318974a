#include "common/course/grade/layers.hpp"

#include "common/course/grade/filter.hpp"
#include "common/course/grade/landlock.hpp"
#include "common/course/grade/seal.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace rt::grade {

namespace {

/// Whether it is so in a process that is thrown away afterwards.
template <class Trial>
bool holds(Trial trial) {
    const pid_t process = fork();
    if (process == 0) _exit(trial() ? 0 : 1);
    int status = 1;
    while (waitpid(process, &status, 0) == -1 && errno == EINTR) continue;
    return process > 0 && status == 0;
}

bool files_are_out_of_reach() {
    const Landlock rules;
    return rules.put_on() && open("/", O_RDONLY | O_DIRECTORY) == -1 && errno == EACCES;
}

bool calls_are_filtered() {
    return filter_system_calls({.work = Work::building}) && socket(AF_UNIX, SOCK_STREAM, 0) == -1 &&
           errno == EPERM;
}

bool memory_is_limited() {
    constexpr int megabytes = 512;
    if (!limit({.megabytes = megabytes}, false)) return false;
    return mmap(nullptr, std::size_t(megabytes) << 20, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                0) == MAP_FAILED;
}

}  // namespace

std::vector<Layer> layers() {
    const std::string version = std::to_string(Landlock::version());
    return {
        {"system calls are filtered (seccomp)", holds(calls_are_filtered), true},
        {"files are out of reach (Landlock, version " + version + ")",
         holds(files_are_out_of_reach), true},
        {"time, memory and output are limited", holds(memory_is_limited), true},
        {"a user of its own for each process (only if root grades)", holds(take_user_of_its_own)},
        {"namespaces of its own for each worker",
         holds([] { return take_namespaces(Work::answering); })},
        {"processes, network and mounts of its own for each compiler",
         holds([] { return take_namespaces(Work::building); })},
    };
}

bool hold(const std::vector<Layer>& layers) {
    return std::all_of(layers.begin(), layers.end(),
                       [](const Layer& layer) { return layer.holds || !layer.needed; });
}

std::string text_of(const std::vector<Layer>& layers) {
    std::string text;
    for (const Layer& layer : layers) text += (layer.holds ? "✓ " : "✗ ") + layer.name + "\n";
    return text;
}

}  // namespace rt::grade
