#include "common/course/grade/seal.hpp"

#include "common/course/grade/filter.hpp"
#include "common/course/grade/landlock.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sched.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

namespace rt::grade {

namespace {

constexpr int program_descriptor = 9;  // closed by the step into the program
constexpr rlim_t megabyte = 1 << 20;

void require(bool holds, const char* what) {
    if (!holds) throw SealError(std::string(what) + ": " + std::strerror(errno));
}

/// Nothing stays open but the channel, if there is one, and what complaints go to until the end.
void close_descriptors(bool worker) {
    struct stat about {};
    const bool has_channel = worker && fstat(channel, &about) == 0 && S_ISSOCK(about.st_mode);
    require(syscall(SYS_close_range, channel + (has_channel ? 1 : 0), ~0U, 0) == 0, "close_range");
    require(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, complaints) == complaints, "standard error");
    const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    require(null != -1, "/dev/null");
    require(dup2(null, STDIN_FILENO) == STDIN_FILENO, "standard input");
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        if (worker) require(dup2(null, output) == output, "standard output");
}

/// The worker's program, opened while it can be: its folders may be closed to the user to come.
void open_program(const std::string& program) {
    const int file = open(program.c_str(), O_RDONLY | O_CLOEXEC);
    require(file != -1 && dup3(file, program_descriptor, O_CLOEXEC) == program_descriptor,
            program.c_str());
}

void forget_signals() {
    for (int each = 1; each < NSIG; ++each) std::signal(each, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

void add_rules(const Seal& seal, Landlock& rules) {
    const bool worker = seal.work == Work::answering;
    if (worker) rules.let_run(program_descriptor);
    if (!worker || seal.libraries)
        for (const char* folder :
             {"/usr/lib", "/usr/lib64", "/usr/local/lib", "/lib", "/lib64", "/etc/ld.so.cache"})
            rules.let_read(folder);
    if (!worker) {
        for (const char* folder : {"/usr/bin", "/usr/libexec", "/usr/include", "/usr/local/include",
                                   "/bin", "/etc/alternatives"})
            rules.let_read(folder);
        rules.let_write("/dev/null");
    }
    for (const std::string& folder : seal.readable) rules.let_read(folder);
    for (const std::string& folder : seal.writable) rules.let_write(folder);
}

/// To the user that this process will be.
void give_away(const std::string& folder) {
    if (geteuid() != 0) return;
    const unsigned user = user_of_its_own();
    require(lchown(folder.c_str(), user, user) == 0, folder.c_str());
}

/// Two steps of one: the process goes on as the child, and the parent waits for it, no longer than
/// it may take, and ends all that came of it.
void go_on_watched(int seconds) {
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    sigprocmask(SIG_BLOCK, &children, nullptr);
    const pid_t child = fork();
    require(child != -1, "no process");
    if (child == 0) {
        setsid();
        sigprocmask(SIG_UNBLOCK, &children, nullptr);
        require(prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "end with the parent");
        return;
    }
    timespec left{.tv_sec = seconds, .tv_nsec = 0};
    const bool in_time = sigtimedwait(&children, nullptr, &left) == SIGCHLD;
    kill(-child, SIGKILL);
    kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) == -1 && errno == EINTR) continue;
    if (!in_time) _exit(128 + SIGXCPU);
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
    all.push_back(nullptr);
    return all;
}

}  // namespace

unsigned user_of_its_own() {
    constexpr unsigned first = 61184;  // systemd's, for services that have none of their own
    constexpr unsigned count = 4000;
    return first + unsigned(getpid()) % count;
}

bool take_user_of_its_own() {
    if (geteuid() != 0) return false;
    const unsigned user = user_of_its_own();
    return setgroups(0, nullptr) == 0 && setresgid(user, user, user) == 0 &&
           setresuid(user, user, user) == 0;
}

bool take_namespaces(Work work) {
    // A network of its own costs as much as all the rest, and a worker's filter knows no socket.
    const int flags = work == Work::answering ? CLONE_NEWUSER | CLONE_NEWIPC
                                              : CLONE_NEWUSER | CLONE_NEWIPC | CLONE_NEWPID |
                                                    CLONE_NEWNET | CLONE_NEWNS;
    return unshare(flags) == 0;
}

bool limit(const Seal& seal, bool processes_are_counted) {
    const auto set = [](auto resource, rlim_t soft, rlim_t hard) {
        const rlimit both{.rlim_cur = soft, .rlim_max = hard};
        return setrlimit(resource, &both) == 0;
    };
    const auto cpu = rlim_t(seal.cpu_seconds);
    const rlim_t memory = rlim_t(seal.megabytes) * megabyte;
    const rlim_t files = rlim_t(seal.file_megabytes) * megabyte;
    const rlim_t stack = 8 * megabyte;
    const rlim_t open_files = seal.work == Work::answering ? 16 : 64;
    return set(RLIMIT_CPU, cpu, cpu + 1) && set(RLIMIT_AS, memory, memory) &&
           set(RLIMIT_FSIZE, files, files) && set(RLIMIT_CORE, 0, 0) &&
           set(RLIMIT_STACK, stack, stack) && set(RLIMIT_NOFILE, open_files, open_files) &&
           set(RLIMIT_MEMLOCK, 0, 0) && set(RLIMIT_MSGQUEUE, 0, 0) &&
           (!processes_are_counted ||
            set(RLIMIT_NPROC, rlim_t(seal.threads), rlim_t(seal.threads)));
}

void become(const Seal& seal, const std::vector<std::string>& command) {
    const bool worker = seal.work == Work::answering;
    close_descriptors(worker);
    if (worker) open_program(command.at(0));
    setsid();
    forget_signals();
    umask(worker ? 077 : 022);  // what one tool made, another of another user reads
    for (const std::string& folder : seal.writable) give_away(folder);
    if (!seal.writable.empty())
        require(chdir(seal.writable.front().c_str()) == 0, seal.writable.front().c_str());
    Landlock rules;
    add_rules(seal, rules);
    const bool root = geteuid() == 0;
    const bool own_user = take_user_of_its_own();
    require(own_user || !root, "no user of its own");
    const bool namespaces = take_namespaces(seal.work);
    // What stands in memory that nobody has set is the same in every run.
    if (worker) personality(ADDR_NO_RANDOMIZE);
    // After the change of user, which forgets it.
    require(prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "end with the parent");
    if (!worker) go_on_watched(seal.wall_seconds);
    // Without either, the limit would count all that the user runs.
    require(limit(seal, own_user || (worker && namespaces)), "limits");
    require(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no new privileges");
    const bool files = rules.put_on();
    require(files || (worker && !seal.libraries), "Landlock");
    require(filter_system_calls(seal), "seccomp");

    std::vector<std::string> environment{"LC_ALL=C", "PATH=/usr/bin:/bin"};
    if (!seal.writable.empty()) environment.push_back("TMPDIR=" + seal.writable.front());
    if (worker)
        syscall(SYS_execveat, program_descriptor, "", pointers(command).data(),
                pointers(environment).data(), AT_EMPTY_PATH);
    else
        execve(command.at(0).c_str(), pointers(command).data(), pointers(environment).data());
    throw SealError(command.at(0) + ": " + std::strerror(errno));
}

}  // namespace rt::grade
