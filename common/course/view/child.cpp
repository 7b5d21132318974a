#include "common/course/view/child.hpp"

#include "common/input_error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <functional>
#include <thread>

extern char** environ;

namespace rt {

namespace {

constexpr std::size_t most_output = 64 * 1024;
constexpr int milliseconds_between_looks = 10;

/// Starts the program in a group of its own, without input; `mouth` takes what it says.
pid_t start(const Command& command, int mouth) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, mouth, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, mouth, STDERR_FILENO);
    pid_t process = 0;
    const int error =
        posix_spawn(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw InputError({}, command[0] + " does not start: " + std::strerror(error));
    return process;
}

/// Keeps what comes from the program, until it closes the pipe or `given_up`.
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

/// Waits for the program's end, and makes it end if it is `given_up`.
int wait_for(pid_t process, const std::function<bool()>& given_up) {
    int answer = 0;
    while (waitpid(process, &answer, WNOHANG) == 0) {
        if (given_up()) kill(-process, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return exit_status(answer);
}

}  // namespace

Ending listen_until(const std::atomic<bool>& cancelled, const Command& command,
                    std::chrono::milliseconds limit) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError({}, "no pipe left to listen with");
    const auto [ear, mouth] = ends;
    pid_t process = 0;
    try {
        process = start(command, mouth);
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
        return cancelled || ending.out_of_time;
    };
    listen(ear, given_up, ending.output);
    close(ear);
    ending.status = wait_for(process, given_up);
    return ending;
}

}  // namespace rt
