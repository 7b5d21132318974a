// Tries forbidden operations of a sealed process: `attacker WHAT [PATH]` ends with status 0 if it
// succeeded. `attacker --no-namespaces PROGRAM ARGUMENTS…` becomes a program that cannot create
// namespaces.
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <vector>

extern char** environ;

namespace {

constexpr const char* program = "/bin/true";
std::string path;

bool opens(int flags) {
    return open(path.c_str(), flags, 0644) != -1;
}

bool starts_threads(int count) {
    std::vector<pthread_t> threads(static_cast<std::size_t>(count));
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    for (pthread_t& thread : threads)
        if (pthread_create(
                &thread, &small, [](void*) -> void* { return sleep(60), nullptr; }, nullptr) != 0)
            return false;
    return true;
}

bool finds_an_open_descriptor() {
    char byte = 0;
    for (int each = 3; each < 1024; ++each)
        if (lseek(each, 0, SEEK_CUR) != -1 || errno != EBADF || read(each, &byte, 0) == 0)
            return true;
    return false;
}

bool finds_the_environment() {
    for (char** word = environ; *word != nullptr; ++word)
        if (std::strncmp(*word, "SECRET=", 7) == 0) return true;
    return false;
}

/// A thread whose creator is blocked in the kernel until it ends.
bool waits_for_a_thread() {
    static char stack[65536];
    const auto thread = [](void*) -> int {
        sleep(60);
        return 0;
    };
    return clone(thread, stack + sizeof stack,
                 CLONE_VM | CLONE_SIGHAND | CLONE_THREAD | CLONE_VFORK, nullptr) != -1;
}

/// By the worker's own descriptor, which an absolute path makes irrelevant.
bool executes_beside_the_descriptor() {
    constexpr int own_program = 9;
    return syscall(SYS_execveat, own_program, path.c_str(), nullptr, environ, AT_EMPTY_PATH) == 0;
}

bool leaves_its_group() {
    const pid_t child = fork();
    if (child == 0) _exit(setsid() != -1 || setpgid(0, 0) == 0 ? 0 : 1);
    int status = 0;
    return waitpid(child, &status, 0) == child && status == 0;
}

bool has_a_child_that_sleeps() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) sleep(60);
        sleep(60);
    }
    return sleep(60) == 0;
}

bool signals_by_a_pipe() {
    int ends[2];
    return pipe(ends) == 0 && fcntl(ends[0], F_SETOWN, getppid()) == 0;
}

bool prints_its_user() {
    return std::printf("%u\n", getuid()) > 0 && std::fflush(stdout) == 0;
}

/// A core that is piped to a program is written even with the limit 0, but not with 1: core(5).
bool pipes_its_core() {
    rlimit core{};
    return getrlimit(RLIMIT_CORE, &core) != 0 || core.rlim_cur != 1 || core.rlim_max != 1;
}

bool leaves_a_daemon() {
    if (fork() == 0) {
        setsid();
        if (fork() == 0) {
            sleep(1);
            opens(O_WRONLY | O_CREAT);
        }
        _exit(0);
    }
    sleep(0);
    return true;
}

bool reads_its_clocks() {
    timespec now{};
    for (const clockid_t each : {CLOCK_REALTIME, CLOCK_MONOTONIC, CLOCK_PROCESS_CPUTIME_ID,
                                 CLOCK_THREAD_CPUTIME_ID, CLOCK_BOOTTIME})
        if (syscall(SYS_clock_gettime, each, &now) != 0 ||
            syscall(SYS_clock_getres, each, &now) != 0)
            return false;
    return true;
}

bool reads_the_clock_of_its_parent() {
    timespec now{};
    const clockid_t clock = clockid_t(~unsigned(getppid()) << 3 | 2);  // of its processor time
    return syscall(SYS_clock_gettime, clock, &now) == 0;
}

[[noreturn]] void spin() {
    for (volatile int i = 0;;) i = i + 1;
}

char first_byte = 0;

const std::map<std::string, std::function<bool()>> attempts{
    {"nothing", [] { return true; }},
    {"read", [] { return opens(O_RDONLY); }},
    {"write", [] { return opens(O_WRONLY | O_CREAT); }},
    {"socket", [] { return socket(AF_INET, SOCK_STREAM, 0) != -1; }},
    {"fork", [] { return fork() != -1; }},
    {"exec", [] { return execl(program, program, nullptr) == 0; }},
    {"exec another way",
     [] { return syscall(SYS_execveat, AT_FDCWD, program, nullptr, environ, AT_EMPTY_PATH) == 0; }},
    {"exec beside", executes_beside_the_descriptor},
    {"wait for a thread", waits_for_a_thread},
    {"leave the group", leaves_its_group},
    {"children", has_a_child_that_sleeps},
    {"signal by a pipe", signals_by_a_pipe},
    {"change mode", [] { return chmod(path.c_str(), 0) == 0; }},
    {"priority", [] { return setpriority(PRIO_PROCESS, pid_t(getppid()), 10) == 0; }},
    {"user", prints_its_user},
    {"core", pipes_its_core},
    {"trace", [] { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0; }},
    {"signal", [] { return kill(path.empty() ? getppid() : std::stoi(path), 0) == 0; }},
    {"memory",
     [] {
         return mmap(nullptr, std::size_t(2) << 30, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                     0) != MAP_FAILED;
     }},
    {"threads", [] { return starts_threads(4); }},
    {"many threads", [] { return starts_threads(200); }},
    {"descriptors", finds_an_open_descriptor},
    {"environment", finds_the_environment},
    {"set the clock",
     [] {
         timespec now{};
         clock_gettime(CLOCK_REALTIME, &now);
         return clock_settime(CLOCK_REALTIME, &now) == 0;
     }},
    {"see", [] { return access(path.c_str(), F_OK) == 0; }},
    {"own clocks", reads_its_clocks},
    {"clock of another", reads_the_clock_of_its_parent},
    {"input", [] { return read(STDIN_FILENO, &first_byte, 1) == 1; }},
    {"nap", [] { return usleep(500000) == 0; }},
    {"print",
     [] { return write(STDOUT_FILENO, "printed", 7) == 7 && write(STDERR_FILENO, "too", 3) == 3; }},
    {"namespaces", [] { return unshare(CLONE_NEWUSER) == 0; }},
    {"root", [] { return setuid(0) == 0; }},
    {"daemon", leaves_a_daemon},
    {"abort", []() -> bool { std::abort(); }},
    {"spin", []() -> bool { spin(); }},
    {"sleep", [] { return sleep(60) == 0; }},
};

/// As in most containers.
int without_namespaces(char** command) {
    sock_filter steps[] = {
        {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
        {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_unshare},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EPERM},
        {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
    };
    const sock_fprog filter{4, steps};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) != 0)
        return 99;
    execv(command[0], command);
    return 99;
}

}  // namespace

int main(int count, char** words) {
    const std::string what = count > 1 ? words[1] : "";
    if (what == "--no-namespaces") return without_namespaces(words + 2);
    if (count > 2) path = words[2];
    constexpr int unknown = 99;
    const auto attempt = attempts.find(what);
    _exit(attempt == attempts.end() ? unknown : attempt->second() ? 0 : 1);
}
