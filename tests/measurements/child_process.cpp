#include "tests/measurements/child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace measurements {

namespace {

double seconds(const timeval& time) {
    return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

double cpu_seconds(const rusage& usage) {
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double wall_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

/// This process, so far.
Usage used() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return {.cpu = cpu_seconds(usage), .wall = wall_seconds()};
}

pid_t forked() {
    std::fflush(nullptr);  // otherwise the child would print the buffered output again
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot create a process");
    return child;
}

/// Waits for the child, and returns the CPU time of all of it.
double waited_for(pid_t child, const std::string& name) {
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child || status != 0)
        throw std::runtime_error(name + " failed");
    return cpu_seconds(usage);
}

[[noreturn]] void become(const std::vector<std::string>& words) {
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

}  // namespace

Usage run(const std::vector<std::string>& words) {
    const double start = wall_seconds();
    const pid_t child = forked();
    if (child == 0) become(words);
    const double cpu = waited_for(child, words.front());
    return {.cpu = cpu, .wall = wall_seconds() - start};
}

std::vector<Usage> run_apart(
    const std::function<void(const std::function<void()>& step_done)>& work) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("cannot create a pipe");
    const pid_t child = forked();
    if (child == 0) {
        try {
            Usage before = used();
            work([&] {
                const Usage now = used();
                const Usage step{.cpu = now.cpu - before.cpu, .wall = now.wall - before.wall};
                if (write(ends[1], &step, sizeof step) != sizeof step) _exit(1);
                before = now;
            });
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            _exit(1);
        }
        _exit(0);
    }
    close(ends[1]);
    std::vector<Usage> steps;
    for (Usage step; read(ends[0], &step, sizeof step) == sizeof step;) steps.push_back(step);
    close(ends[0]);
    waited_for(child, "the separate process");
    return steps;
}

}  // namespace measurements
