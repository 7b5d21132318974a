#include "common/course/process.hpp"

#include "common/input_error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

extern char** environ;

namespace rt {

namespace {

constexpr std::size_t most_output = 64 * 1024;
constexpr int signalled = 128;

/// Starts the program; `output` takes both its streams, unless it is -1.
pid_t start(const Command& command, int output) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &interrupt);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (output != -1) {
        posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    }
    pid_t process = 0;
    const int error =
        posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw InputError({}, command[0] + " does not start: " + std::strerror(error));
    return process;
}

int wait_for(pid_t process) {
    int answer = 0;
    while (waitpid(process, &answer, 0) == -1 && errno == EINTR) continue;
    return exit_status(answer);
}

}  // namespace

int run_process(const Command& command) {
    // Ctrl-C is the program's to answer: who waits for it must live to hear how it ended.
    const auto previous = std::signal(SIGINT, SIG_IGN);
    const int status = wait_for(start(command, -1));
    std::signal(SIGINT, previous);
    // A shell would say so, but it only sees us.
    if (!crash(status).empty() && status != signalled + SIGINT)
        std::fprintf(stderr, "error: %s crashed: %s\n", command[0].c_str(), crash(status).c_str());
    return status;
}

Ending listen_to(const Command& command, std::chrono::seconds limit) {
    using Clock = std::chrono::steady_clock;
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError({}, "no pipe left to listen with");
    const auto [ear, mouth] = ends;
    const Clock::time_point end = Clock::now() + limit;
    Ending ending;
    pid_t process = 0;
    try {
        process = start(command, mouth);
    } catch (...) {
        close(ear);
        close(mouth);
        throw;
    }
    close(mouth);
    std::array<char, 4096> heard{};
    for (pollfd question{ear, POLLIN, 0};;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        const int ready = poll(&question, 1, int(std::max<long long>(left, 0)));
        if (ready == -1 && errno == EINTR) continue;
        if (ready == 0) {
            ending.out_of_time = true;
            kill(process, SIGKILL);
            break;
        }
        const ssize_t count = read(ear, heard.data(), heard.size());
        if (count == -1 && errno == EINTR) continue;
        if (count <= 0) break;
        const std::size_t room = most_output - ending.output.size();
        ending.output.append(heard.data(), std::min(std::size_t(count), room));
    }
    close(ear);
    ending.status = wait_for(process);
    return ending;
}

int exit_status(int answer) {
    return WIFEXITED(answer) ? WEXITSTATUS(answer) : signalled + WTERMSIG(answer);
}

std::string crash(int status) {
    return status > signalled ? strsignal(status - signalled) : "";
}

}  // namespace rt
