#include "common/system/process.hpp"

#include "common/system/countdown.hpp"
#include "common/system/descriptors.hpp"
#include "common/system/end_with_parent.hpp"
#include "common/system/input_error.hpp"
#include "common/system/orphans.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <sstream>
#include <thread>

namespace rt {

namespace {

constexpr int signalled = 128;
constexpr int milliseconds_between_looks = 10;
constexpr int milliseconds_to_end = 200;

enum class Group { callers, its_own };

/// How a program is started.
struct Launch {
    Streams streams = Streams::both;  ///< those that `output` takes
    int signal = SIGTERM;             ///< what it gets when its caller ends
    Group group = Group::callers;
    int output = -1;  ///< a descriptor; -1 for the caller's streams, also for its input
};

/// In the child: becomes the program, or returns why not. Calls nothing that might wait for another
/// thread of the parent.
int become(char** arguments, const Launch& launch, pid_t parent) {
    signal(SIGINT, SIG_DFL);
    if (launch.group == Group::its_own) setpgid(0, 0);
    end_with_parent(launch.signal);
    if (getppid() != parent) _exit(signalled + SIGKILL);
    if (launch.output != -1) {
        const int nothing = open("/dev/null", O_RDONLY);
        if (nothing == -1 || dup2(nothing, STDIN_FILENO) == -1) return errno;
        if (nothing != STDIN_FILENO) close(nothing);
        if (dup2(launch.output, STDOUT_FILENO) == -1) return errno;
        if (launch.streams == Streams::both && dup2(launch.output, STDERR_FILENO) == -1)
            return errno;
    }
    execvp(arguments[0], arguments);
    return errno;
}

/// The status from waitpid. `used` becomes what the process has used, and those that it has waited
/// for.
int wait_for(pid_t process, rusage* used = nullptr) {
    int answer = 0;
    while (wait4(process, &answer, 0, used) == -1 && errno == EINTR) continue;
    note_end(process);
    return answer;
}

double processor_seconds(const rusage& used) {
    const auto seconds = [](const timeval& time) {
        return double(time.tv_sec) + double(time.tv_usec) * 1e-6;
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

pid_t start(const Command& command, const Launch& launch) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    std::array<int, 2> failure{};
    if (!make_pipe(failure)) throw InputError({}, "cannot create a pipe");
    const pid_t parent = getpid();
    std::unique_lock lock(inheritance);
    const pid_t process = fork();
    int error = process == -1 ? errno : 0;
    if (process == 0) {
        error = become(arguments.data(), launch, parent);
        _exit(write(failure[1], &error, sizeof error) == sizeof error ? 1 : 2);
    }
    if (process > 0) note_start(process);
    lock.unlock();
    close(failure[1]);
    // Nothing can be read after a successful exec.
    while (process > 0 && read(failure[0], &error, sizeof error) == -1 && errno == EINTR) continue;
    close(failure[0]);
    if (error == 0) return process;
    if (process > 0) wait_for(process);
    throw InputError({}, command[0] + " cannot be started: " + std::strerror(error));
}

/// A program, and the end of a pipe where its output arrives.
struct HeardProgram {
    pid_t process;
    int ear;
};

HeardProgram start_heard(const Command& command, Launch launch) {
    std::array<int, 2> ends{};
    if (!make_pipe(ends)) throw InputError({}, "cannot create a pipe");
    const auto [ear, mouth] = ends;
    launch.output = mouth;
    try {
        const pid_t process = start(command, launch);
        close(mouth);
        return {.process = process, .ear = ear};
    } catch (...) {
        close(ear);
        close(mouth);
        throw;
    }
}

/// Passes the program's output on until it closes the pipe or `hear` returns false. `hear` gets an
/// empty piece when nothing was printed for a while.
void listen(int ear, int milliseconds, const std::function<bool(std::string_view piece)>& hear) {
    std::array<char, 4096> heard{};
    std::size_t size = 0;
    while (hear({heard.data(), size})) {
        size = 0;
        pollfd question{ear, POLLIN, 0};
        if (poll(&question, 1, milliseconds) != 1) continue;
        const ssize_t count = read(ear, heard.data(), heard.size());
        if (count == -1 && errno == EINTR) continue;
        if (count <= 0) break;
        size = std::size_t(count);
    }
    close(ear);
}

/// Returns whether the process has ended. It keeps its number until wait_for.
bool has_ended(pid_t process) {
    siginfo_t about{};
    return waitid(P_PID, id_t(process), &about, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           about.si_pid == process;
}

/// The signal's name; not to be had of an exit status, since a suite's is the number of failures.
std::string crash(int answer) {
    return WIFSIGNALED(answer) ? strsignal(WTERMSIG(answer)) : "";
}

}  // namespace

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::error_code none;
        if (std::filesystem::is_regular_file(std::filesystem::path(folder) / program, none))
            return true;
    }
    return false;
}

int run_process(const Command& command) {
    // Ctrl-C is for the program: its parent must survive to report how it ended.
    const auto previous = std::signal(SIGINT, SIG_IGN);
    const int answer = wait_for(start(command, {}));
    std::signal(SIGINT, previous);
    // A shell would report the crash, but it only sees this process. An end by Ctrl-C is none, nor
    // by a reader that has read enough, such as `head`.
    const std::string crashed = crash(answer);
    if (!crashed.empty() && WTERMSIG(answer) != SIGINT && WTERMSIG(answer) != SIGPIPE)
        std::fprintf(stderr, "error: %s crashed: %s\n", command[0].c_str(), crashed.c_str());
    return exit_status(answer);
}

int run_heard(const Command& command, Streams streams,
              const std::function<void(std::string_view)>& hear) {
    constexpr int second = 1000;
    const auto [process, ear] = start_heard(command, {.streams = streams});
    listen(ear, second, [&hear](std::string_view piece) {
        hear(piece);
        return true;
    });
    return exit_status(wait_for(process));
}

ProcessResult run_captured(const Command& command, std::chrono::milliseconds limit,
                           const std::atomic<bool>* cancelled, std::size_t most_output) {
    const Orphans orphans;
    const Group group = cancelled == nullptr ? Group::callers : Group::its_own;
    const HeardProgram program = start_heard(command, {.signal = SIGKILL, .group = group});
    const pid_t process = program.process;
    Countdown countdown(limit);
    ProcessResult ending;
    const auto is_late = [&countdown] { return countdown.look() <= Countdown::Time::zero(); };
    const auto is_cancelled = [cancelled] { return cancelled != nullptr && *cancelled; };
    bool ended = false;
    listen(program.ear, milliseconds_between_looks, [&](std::string_view piece) {
        ending.output += piece.substr(0, most_output - ending.output.size());
        if (ended && piece.empty()) return false;  // the pipe is open in a process that it left
        ended = has_ended(process);
        return !is_late() && !is_cancelled();
    });
    // It may continue with closed streams.
    for (int asked_to_end = 0; !has_ended(process);) {
        ending.out_of_time = ending.out_of_time || is_late();
        // It may have to end its own children first.
        if (ending.out_of_time || is_cancelled())
            kill(group == Group::callers ? process : -process,
                 ++asked_to_end < milliseconds_to_end ? SIGTERM : SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (group == Group::its_own) kill(-process, SIGKILL);  // what it has left
    rusage used{};
    const int answer = wait_for(process, &used);
    ending.status = exit_status(answer);
    ending.crash = crash(answer);
    ending.processor_seconds = processor_seconds(used);
    return ending;
}

int exit_status(int answer) {
    return WIFEXITED(answer) ? WEXITSTATUS(answer) : signalled + WTERMSIG(answer);
}

bool is_stopped(int status) {
    return status == signalled + SIGTERM || status == signalled + SIGINT ||
           status == signalled + SIGHUP;
}

}  // namespace rt
