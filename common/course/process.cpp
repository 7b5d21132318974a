#include "common/course/process.hpp"

#include "common/input_error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <functional>
#include <thread>

extern char** environ;

namespace rt {

namespace {

constexpr std::size_t most_output = 64 * 1024;
constexpr int signalled = 128;
constexpr int milliseconds_between_looks = 10;

enum class Group { ours, its_own };

/// Starts the program; `output` takes both its streams, unless it is -1.
pid_t start(const Command& command, int output, Group group) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t interrupt;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &interrupt);
    short flags = POSIX_SPAWN_SETSIGDEF;
    if (group == Group::its_own) flags |= POSIX_SPAWN_SETPGROUP;
    posix_spawnattr_setflags(&attributes, flags);
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

/// Keeps what comes from the program, until it closes the pipe or is `given_up`.
void listen(int ear, const std::function<bool()>& given_up, std::string& output) {
    std::array<char, 4096> heard{};
    while (!given_up()) {
        pollfd question{ear, POLLIN, 0};
        if (poll(&question, 1, milliseconds_between_looks) != 1) continue;
        const ssize_t count = read(ear, heard.data(), heard.size());
        if (count == -1 && errno == EINTR) continue;
        if (count <= 0) return;
        output.append(heard.data(), std::min(std::size_t(count), most_output - output.size()));
    }
}

/// What waitpid tells of its end.
int wait_for(pid_t process) {
    int answer = 0;
    while (waitpid(process, &answer, 0) == -1 && errno == EINTR) continue;
    return answer;
}

/// The signal's name; not to be had of an exit status, since a suite's is the number of failures.
std::string crash(int answer) {
    return WIFSIGNALED(answer) ? strsignal(WTERMSIG(answer)) : "";
}

}  // namespace

int run_process(const Command& command) {
    // Ctrl-C is the program's to answer: who waits for it must live to hear how it ended.
    const auto previous = std::signal(SIGINT, SIG_IGN);
    const int answer = wait_for(start(command, -1, Group::ours));
    std::signal(SIGINT, previous);
    // A shell would say so, but it only sees us.
    const std::string crashed = crash(answer);
    if (!crashed.empty() && WTERMSIG(answer) != SIGINT)
        std::fprintf(stderr, "error: %s crashed: %s\n", command[0].c_str(), crashed.c_str());
    return exit_status(answer);
}

Ending listen_to(const Command& command, std::chrono::milliseconds limit,
                 const std::atomic<bool>* cancelled) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError({}, "no pipe left to listen with");
    const auto [ear, mouth] = ends;
    const Group group = cancelled == nullptr ? Group::ours : Group::its_own;
    pid_t process = 0;
    try {
        process = start(command, mouth, group);
    } catch (...) {
        close(ear);
        close(mouth);
        throw;
    }
    close(mouth);
    const auto deadline = std::chrono::steady_clock::now() + limit;
    Ending ending;
    const auto given_up = [&] {
        ending.out_of_time = std::chrono::steady_clock::now() >= deadline;
        return ending.out_of_time || (cancelled != nullptr && *cancelled);
    };
    listen(ear, given_up, ending.output);
    close(ear);
    // It may have closed its streams, and go on.
    int answer = 0;
    while (waitpid(process, &answer, WNOHANG) == 0) {
        if (given_up()) kill(group == Group::ours ? process : -process, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ending.status = exit_status(answer);
    ending.crash = crash(answer);
    return ending;
}

int exit_status(int answer) {
    return WIFEXITED(answer) ? WEXITSTATUS(answer) : signalled + WTERMSIG(answer);
}

}  // namespace rt
