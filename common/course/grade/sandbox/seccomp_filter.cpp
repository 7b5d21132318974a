#include "common/course/grade/sandbox/seal.hpp"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <initializer_list>

namespace rt::grade {

namespace {

using Names = std::initializer_list<const char*>;
using Conditions = std::initializer_list<scmp_arg_cmp>;

constexpr std::uint32_t end_process = SCMP_ACT_KILL_PROCESS;
constexpr std::uint32_t pretended = SCMP_ACT_ERRNO(0);  // returns success, and nothing is done

constexpr std::uint32_t refused(int error) {
    return SCMP_ACT_ERRNO(std::uint32_t(error));
}

scmp_arg_cmp argument_is(unsigned argument, std::uint64_t value) {
    return {.arg = argument, .op = SCMP_CMP_EQ, .datum_a = value, .datum_b = 0};
}

/// The condition that the masked bits equal `bits`.
scmp_arg_cmp bits_are(unsigned argument, std::uint64_t mask, std::uint64_t bits) {
    return {.arg = argument, .op = SCMP_CMP_MASKED_EQ, .datum_a = mask, .datum_b = bits};
}

/// A list of allowed system calls, and the default result of all others. Calls by the numbers of
/// another architecture end the process.
class Filter {
public:
    explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
        holds_ = context_ != nullptr;
        note(seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, end_process));
    }
    ~Filter() { seccomp_release(context_); }
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;

    void let(Names calls) { answer(SCMP_ACT_ALLOW, calls); }

    void let_if(const char* call, Conditions conditions) {
        answer_if(SCMP_ACT_ALLOW, call, conditions);
    }

    void answer(std::uint32_t what, Names calls) {
        for (const char* call : calls) answer_if(what, call, {});
    }

    /// If all conditions are true.
    void answer_if(std::uint32_t what, const char* call, Conditions conditions) {
        note(seccomp_rule_add_array(context_, what, number(call), unsigned(conditions.size()),
                                    conditions.begin()));
    }

    [[nodiscard]] bool put_on() const { return holds_ && seccomp_load(context_) == 0; }

private:
    /// A name that does not exist on this architecture gets a number without a system call.
    int number(const char* call) {
        const int number = seccomp_syscall_resolve_name(call);
        holds_ = holds_ && number != __NR_SCMP_ERROR;
        return number;
    }

    void note(int error) { holds_ = holds_ && error == 0; }

    scmp_filter_ctx context_;
    bool holds_ = false;
};

/// The clocks of the system, and of the process itself. Other numbers are the processor time of
/// another process, by which two could talk.
void let_clocks(Filter& filter) {
    constexpr std::uint64_t last = 11;  // CLOCK_TAI
    for (const char* call : {"clock_gettime", "clock_getres", "clock_nanosleep"})
        filter.let_if(call, {{.arg = 0, .op = SCMP_CMP_LE, .datum_a = last, .datum_b = 0}});
}

void let_threads(Filter& filter) {
    // The flags of a thread, as pthread_create sets them, and no others: a parent waiting for its
    // child (CLONE_VFORK) would be blocked without using processor time or sleeping.
    constexpr std::uint64_t needed = CLONE_VM | CLONE_SIGHAND | CLONE_THREAD;
    constexpr std::uint64_t harmless = CLONE_FS | CLONE_FILES | CLONE_SYSVSEM | CLONE_SETTLS |
                                       CLONE_PARENT_SETTID | CLONE_CHILD_CLEARTID |
                                       CLONE_CHILD_SETTID | CLONE_DETACHED;
    filter.let_if("clone", {bits_are(0, ~harmless, needed)});
}

bool filter_worker() {
    Filter filter(end_process);
    // Its channel, its memory, its own threads and signals, the time, and its end.
    filter.let({"read", "write", "readv", "writev", "close", "lseek", "fstat"});
    filter.let({"brk", "mmap", "munmap", "mremap", "mprotect", "madvise"});
    filter.let({"futex", "set_tid_address", "set_robust_list", "rseq", "gettid", "getpid"});
    // A loop that left a busy processor to others would neither compute nor sleep.
    filter.answer(pretended, {"sched_yield"});
    filter.let({"rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack"});
    filter.let({"gettimeofday", "nanosleep", "restart_syscall", "getrandom"});
    let_clocks(filter);
    filter.let({"exit", "exit_group"});
    filter.let_if("tgkill", {argument_is(0, std::uint64_t(getpid()))});  // abort
    let_threads(filter);
    filter.answer(refused(ENOSYS), {"clone3"});  // its flags are in memory: back to clone
    // The execution of the worker itself. Landlock lets it run no other program, so a path argument
    // is harmless.
    filter.let_if("execveat", {argument_is(0, program_descriptor), argument_is(4, AT_EMPTY_PATH)});
    constexpr int set_thread_pointer = 0x1002;
    filter.let_if("arch_prctl", {argument_is(0, set_thread_pointer)});
    constexpr int control_flow_status = 0x3001;  // needed at the start of a program
    filter.answer_if(refused(EACCES), "arch_prctl", {argument_is(0, control_flow_status)});
    filter.answer(refused(EACCES), {"time", "open", "stat", "access", "readlink", "poll"});
    // Calls that forgotten debugging code tries: they need not cost a case.
    filter.answer(
        refused(EACCES),
        {"openat",  "newfstatat", "statx",   "faccessat", "readlinkat",        "ioctl",
         "fcntl",   "uname",      "sysinfo", "prctl",     "prlimit64",         "getuid",
         "geteuid", "getgid",     "getegid", "getppid",   "sched_getaffinity", "getrusage",
         "getcwd",  "ppoll"});
    return filter.put_on();
}

bool filter_compiler() {
    // A tool works without calls that seem missing.
    Filter filter(refused(ENOSYS));
    // Files: Landlock decides which ones.
    filter.let({"open",      "openat",          "close",      "read",
                "write",     "readv",           "writev",     "pread64",
                "pwrite64",  "preadv",          "pwritev",    "lseek",
                "stat",      "fstat",           "lstat",      "newfstatat",
                "statx",     "access",          "faccessat",  "faccessat2",
                "readlink",  "readlinkat",      "getdents64", "getcwd",
                "chdir",     "fchdir",          "statfs",     "fstatfs",
                "umask",     "ftruncate",       "fallocate",  "fadvise64",
                "fsync",     "fdatasync",       "msync",      "sync_file_range",
                "unlink",    "unlinkat",        "rename",     "renameat",
                "renameat2", "mkdir",           "mkdirat",    "rmdir",
                "link",      "linkat",          "symlink",    "symlinkat",
                "sendfile",  "copy_file_range", "close_range"});
    filter.let({"pipe", "pipe2", "dup", "dup2", "dup3", "poll", "ppoll", "select", "pselect6",
                "epoll_create1", "epoll_ctl", "epoll_wait", "epoll_pwait", "eventfd2"});
    // Without F_SETOWN, by which a pipe signals another process.
    for (const int command : {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_GETLK,
                              F_SETLK, F_SETLKW, F_GETPIPE_SZ, F_SETPIPE_SZ})
        filter.let_if("fcntl", {argument_is(1, std::uint64_t(command))});
    // The owner and the age of a file are never used; and a descriptor open for reading is enough
    // to change them.
    filter.answer(pretended, {"chmod", "fchmod", "fchmodat", "chown", "fchown", "lchown",
                              "fchownat", "utime", "utimes", "futimesat", "utimensat"});
    filter.answer(refused(ENOTTY), {"ioctl"});
    // Memory, threads, the time.
    filter.let({"brk", "mmap", "munmap", "mremap", "mprotect", "madvise"});
    filter.let({"futex", "set_tid_address", "set_robust_list", "get_robust_list", "rseq",
                "sched_yield", "membarrier"});
    filter.let({"gettimeofday", "time", "times", "nanosleep", "restart_syscall", "getrandom",
                "getrusage", "getrlimit", "setrlimit", "sysinfo", "uname", "arch_prctl"});
    let_clocks(filter);
    // Its own, and no other process's.
    for (const char* call : {"prlimit64", "sched_getaffinity", "getpgid", "getsid"})
        filter.let_if(call, {argument_is(0, 0)});
    filter.let_if("prctl", {argument_is(0, PR_SET_NAME)});
    filter.let({"rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigsuspend",
                "rt_sigtimedwait", "rt_sigpending", "sigaltstack", "alarm", "setitimer"});
    // Processes stay in the group that is killed at the end: no setsid, no setpgid.
    filter.let({"fork", "vfork", "execve", "wait4", "waitid", "exit", "exit_group"});
    constexpr std::uint64_t of_their_own = CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID |
                                           CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS |
                                           CLONE_NEWCGROUP | CLONE_PTRACE | CLONE_UNTRACED;
    filter.let_if("clone", {bits_are(0, of_their_own, 0)});
    filter.let({"getpid", "gettid", "getppid", "getpgrp", "getuid", "geteuid", "getgid", "getegid",
                "getresuid", "getresgid", "getgroups"});
    return filter.put_on();
}

}  // namespace

bool filter_system_calls(const Sandbox& seal) {
    return seal.work == Work::answering ? filter_worker() : filter_compiler();
}

}  // namespace rt::grade
