#include "common/course/process.hpp"

#include "common/input_error.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

extern char** environ;

namespace rt {

int run_process(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    // Ctrl-C is the program's to answer: who waits for it must live to hear how it ended.
    const auto previous = std::signal(SIGINT, SIG_IGN);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &interrupt);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t process = 0;
    const int error =
        posix_spawnp(&process, arguments[0], nullptr, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw InputError({}, command[0] + " does not start: " + std::strerror(error));
    int status = 0;
    while (waitpid(process, &status, 0) == -1 && errno == EINTR) continue;
    std::signal(SIGINT, previous);
    // A shell would say so, but it only sees us.
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGINT)
        std::fprintf(stderr, "error: %s crashed: %s\n", command[0].c_str(),
                     strsignal(WTERMSIG(status)));
    return exit_status(status);
}

int exit_status(int answer) {
    return WIFEXITED(answer) ? WEXITSTATUS(answer) : 128 + WTERMSIG(answer);
}

}  // namespace rt
