#include "common/course/grade/sandbox/seal.hpp"

#include "common/course/grade/sandbox/layers.hpp"
#include "common/system/countdown.hpp"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace rt::grade {

namespace {

constexpr rlim_t megabyte = 1 << 20;

void require(bool holds, const char* what) {
    if (!holds) throw SealError(std::string(what) + ": " + std::strerror(errno));
}

/// Closes all descriptors but the channel, if there is one, and the one for error messages.
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

/// Opens the standard input before the change of user, who may not be able to read it.
void open_input(const std::string& file) {
    const int input = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    require(input != -1 && dup2(input, STDIN_FILENO) == STDIN_FILENO, file.c_str());
}

/// Opens the worker's program before the change of user, who may not be able to enter its folders.
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

void add_rules(const Sandbox& seal, Landlock& rules) {
    const bool worker = seal.work == Work::answering;
    if (worker) {
        rules.let_run(program_descriptor);
    } else {
        for (const char* folder :
             {"/usr/bin", "/usr/lib", "/usr/lib64", "/usr/libexec", "/usr/include",
              "/usr/local/bin", "/usr/local/lib", "/usr/local/libexec", "/usr/local/include",
              "/bin", "/lib", "/lib64", "/etc/ld.so.cache", "/etc/alternatives"})
            rules.let_read(folder);
        rules.let_write("/dev/null");
    }
    for (const std::string& folder : seal.readable) rules.let_read(folder);
    for (const std::string& folder : seal.writable) rules.let_write(folder);
}

/// The path without links; itself, if there is no such file.
std::string real(const std::string& path) {
    char* const found = realpath(path.c_str(), nullptr);
    std::string name = found == nullptr ? path : found;
    std::free(found);
    return name;
}

/// Makes folders of people and services look empty, in a mount namespace of this process: Landlock
/// alone forbids their files, but its errors reveal which of them exist.
void hide_folders(const Sandbox& seal, const std::string& program) {
    std::vector<std::string> needed{real(program)};
    for (const auto& list : {seal.readable, seal.writable})
        for (const std::string& each : list) needed.push_back(real(each));
    for (const char* each : {"/home", "/media", "/mnt", "/opt", "/root", "/srv", "/var"}) {
        const std::string folder = real(each);
        const auto is_inside = [start = folder + "/"](const std::string& file) {
            return (file + "/").starts_with(start);
        };
        if (std::ranges::none_of(needed, is_inside))
            (void)mount("none", folder.c_str(), "tmpfs", MS_RDONLY | MS_NOSUID | MS_NODEV,
                        "size=4k");  // if it is there
    }
}

/// True if another process may be started now.
bool can_fork() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    while (child > 0 && waitpid(child, nullptr, 0) == -1 && errno == EINTR) continue;
    return child > 0;
}

/// The number of processes and threads of this user, by the kernel's own count: the limit at which
/// no more can be started. (A count in /proc would be limited to the visible processes.)
rlim_t processes_of_user() {
    rlimit before{};
    if (getrlimit(RLIMIT_NPROC, &before) != 0) return 0;
    const auto is_enough = [&](rlim_t limit) {
        const rlimit tried{.rlim_cur = std::min(limit, before.rlim_max),
                           .rlim_max = before.rlim_max};
        return limit >= before.rlim_max || (setrlimit(RLIMIT_NPROC, &tried) == 0 && can_fork());
    };
    rlim_t enough = 2;  // this process, and one more
    rlim_t too_few = 1;
    for (; !is_enough(enough); enough *= 2) too_few = enough;
    while (enough - too_few > 1) {
        const rlim_t middle = too_few + (enough - too_few) / 2;
        (is_enough(middle) ? enough : too_few) = middle;
    }
    setrlimit(RLIMIT_NPROC, &before);
    return enough - 1;
}

/// The signals for the end of the sealed process, and for the end of its client.
sigset_t watched_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int each : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, each);
    return signals;
}

/// The received signal; 0 at the end of the countdown.
int wait_for_one_of(const sigset_t& signals, Countdown& countdown) {
    while (countdown.look() > Countdown::Time::zero()) {
        const timespec between{.tv_sec = 0, .tv_nsec = Countdown::longest_look.count() / 2};
        const int signal = sigtimedwait(&signals, nullptr, &between);
        if (signal > 0) return signal;
    }
    return 0;
}

/// Forks: the process continues as the child. The parent waits for it until the time limit, and
/// kills its process group, which the filter does not let any process leave.
void go_on_watched(int seconds) {
    const sigset_t signals = watched_signals();
    sigprocmask(SIG_BLOCK, &signals, nullptr);
    require(prctl(PR_SET_PDEATHSIG, SIGTERM, 0, 0, 0) == 0, "end with the parent");
    require(prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) == 0, "whose parents have ended");
    const pid_t child = fork();
    require(child != -1, "no process");
    if (child == 0) {
        setsid();
        sigprocmask(SIG_UNBLOCK, &signals, nullptr);
        require(prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "end with the parent");
        return;
    }
    Countdown countdown{std::chrono::seconds(seconds)};
    int signal = SIGCHLD;
    int status = 0;
    pid_t ended = 0;
    // Orphans of other parents become children of this process.
    while (ended != child && signal == SIGCHLD) {
        signal = wait_for_one_of(signals, countdown);
        while (ended != child && (ended = waitpid(-1, &status, WNOHANG)) > 0) continue;
    }
    kill(-child, SIGKILL);
    if (ended != child) kill(child, SIGKILL);  // it has no group yet
    for (int other = 0; waitpid(-1, &other, 0) != -1 || errno == EINTR;) continue;
    if (ended != child) _exit(128 + (signal > 0 ? signal : SIGXCPU));
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
    all.push_back(nullptr);
    return all;
}

}  // namespace

bool take_user_of_its_own(const Sandbox& seal) {
    constexpr unsigned first = 61184;  // systemd's range for services without a user of their own
    constexpr unsigned count = 4000;
    if (geteuid() != 0) return false;
    const gid_t group = builders_group;
    if (setgroups(seal.work == Work::building ? 1 : 0, &group) != 0) return false;
    for (unsigned i = 0; i < count; ++i) {
        const unsigned user = first + (unsigned(getpid()) + i) % count;
        for (const std::string& folder : seal.writable)
            if (lchown(folder.c_str(), user, user) != 0) return false;
        if (setresgid(user, user, user) != 0 || setresuid(user, user, 0) != 0) return false;
        // If two processes take the same user at once, at least one of them sees both, and retries.
        if (processes_of_user() == 1) return setresuid(user, user, user) == 0;
        if (setresuid(0, 0, 0) != 0) return false;
    }
    return false;
}

bool take_namespaces(Work work) {
    // A separate network costs as much as all the rest, and a worker's filter allows no socket.
    const int flags = work == Work::answering ? CLONE_NEWUSER | CLONE_NEWIPC
                                              : CLONE_NEWUSER | CLONE_NEWIPC | CLONE_NEWPID |
                                                    CLONE_NEWNET | CLONE_NEWNS;
    return unshare(flags) == 0;
}

bool limit(const Sandbox& seal) {
    const auto set = [](auto resource, rlim_t soft, rlim_t hard) {
        const rlimit both{.rlim_cur = soft, .rlim_max = hard};
        return setrlimit(resource, &both) == 0;
    };
    const auto cpu = rlim_t(seal.cpu_seconds);
    const rlim_t memory = rlim_t(seal.megabytes) * megabyte;
    const rlim_t files = rlim_t(seal.file_megabytes) * megabyte;
    const rlim_t stack = 8 * megabyte;
    const rlim_t open_files = seal.work == Work::answering ? 16 : 64;
    rlimit before{};
    if (getrlimit(RLIMIT_NPROC, &before) != 0) return false;
    const rlim_t processes = std::min(before.rlim_max, processes_of_user() + rlim_t(seal.threads));
    if (getrlimit(RLIMIT_CORE, &before) != 0) return false;
    // With 0 it would still be piped to a program, where the system has one; a caller may have 0.
    const rlim_t core = std::min<rlim_t>(before.rlim_max, 1);
    return set(RLIMIT_CPU, cpu, cpu + 1) && set(RLIMIT_AS, memory, memory) &&
           set(RLIMIT_FSIZE, files, files) && set(RLIMIT_CORE, core, core) &&
           set(RLIMIT_STACK, stack, stack) && set(RLIMIT_NOFILE, open_files, open_files) &&
           set(RLIMIT_MEMLOCK, 0, 0) && set(RLIMIT_MSGQUEUE, 0, 0) &&
           set(RLIMIT_NPROC, processes, processes);
}

void become(const Sandbox& seal, const std::vector<std::string>& command) {
    const bool worker = seal.work == Work::answering;
    const pid_t parent = getppid();
    close_descriptors(worker);
    if (worker) open_program(command.at(0));
    if (!seal.input.empty()) open_input(seal.input);
    setsid();
    forget_signals();
    umask(worker ? 077 : 022);  // the output of one tool is read by another with a different user
    if (!seal.writable.empty())
        require(chdir(seal.writable.front().c_str()) == 0, seal.writable.front().c_str());
    Landlock rules;
    add_rules(seal, rules);
    const bool root = geteuid() == 0;
    require(take_user_of_its_own(seal) || !root, "separate user");
    // If namespaces are available.
    if (take_namespaces(seal.work) && !worker) hide_folders(seal, command.at(0));
    // Makes the contents of uninitialized memory the same in every run.
    if (worker) personality(ADDR_NO_RANDOMIZE);
    // After the change of user, which resets it.
    require(prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) == 0, "end with the parent");
    if (getppid() != parent) _exit(128 + SIGKILL);
    if (!worker) go_on_watched(seal.wall_seconds);
    require(limit(seal), "limits");
    require(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no new privileges");
    const bool files = rules.put_on();
    require(files || worker, "Landlock");
    require(filter_system_calls(seal), "seccomp");

    std::vector<std::string> environment{"LC_ALL=C", "PATH=/usr/local/bin:/usr/bin:/bin"};
    if (!seal.writable.empty()) environment.push_back("TMPDIR=" + seal.writable.front());
    if (!worker) {
        environment.emplace_back("SOURCE_DATE_EPOCH=0");  // __DATE__ and __TIME__
        // The compiler may be ccache, which wants a home even so.
        environment.insert(environment.end(), {"CCACHE_DISABLE=1", "HOME=/"});
    }
    if (worker)
        syscall(SYS_execveat, program_descriptor, "", pointers(command).data(),
                pointers(environment).data(), AT_EMPTY_PATH);
    else
        execve(command.at(0).c_str(), pointers(command).data(), pointers(environment).data());
    throw SealError(command.at(0) + ": " + std::strerror(errno));
}

double busy() {
    constexpr double most = 15;
    struct sysinfo about {};
    if (sysinfo(&about) != 0) return most;  // the load is unknown
    const double load = double(about.loads[0]) / (1 << SI_LOAD_SHIFT);
    return std::clamp(load / std::max(1, get_nprocs()), 1.0, most);
}

}  // namespace rt::grade
