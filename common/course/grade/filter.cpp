#include "common/course/grade/filter.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace rt::grade {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
#error "the filter knows the system calls of x86-64 and of aarch64"
#endif

using Calls = std::initializer_list<long>;

constexpr std::uint32_t allow = SECCOMP_RET_ALLOW;
constexpr std::uint32_t end_process = SECCOMP_RET_KILL_PROCESS;

constexpr std::uint32_t refuse(int error) {
    return SECCOMP_RET_ERRNO | std::uint32_t(error);
}

/// A program that the kernel runs on each system call, its number in the accumulator.
class Filter {
public:
    Filter() {
        load(offsetof(seccomp_data, arch));
        step(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
        answer(end_process);
        load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
        constexpr std::uint32_t first_of_x32 = 0x40000000;  // the same calls, by other numbers
        step(BPF_JMP | BPF_JGE | BPF_K, first_of_x32, 0, 1);
        answer(end_process);
#endif
    }

    void each(Calls calls, std::uint32_t what) {
        for (const long call : calls) {
            step(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 1);
            answer(what);
        }
    }

    /// Only if the argument is this (its lower half: the kernel reads no more of an int).
    void if_argument_is(long call, int argument, std::uint32_t value, std::uint32_t what) {
        only_if(call, argument, BPF_JEQ, value, what);
    }

    /// Only if the argument has a bit of these.
    void if_argument_has(long call, int argument, std::uint32_t bits, std::uint32_t what) {
        only_if(call, argument, BPF_JSET, bits, what);
    }

    void answer(std::uint32_t what) {
        step(BPF_RET | BPF_K, what, 0, 0);
    }

    [[nodiscard]] bool put_on() const {
        const sock_fprog program{static_cast<unsigned short>(steps_.size()),
                                 const_cast<sock_filter*>(steps_.data())};
        return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
               syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
    }

private:
    void step(int code, std::uint32_t value, int if_so, int if_not) {
        steps_.push_back({static_cast<std::uint16_t>(code), static_cast<std::uint8_t>(if_so),
                          static_cast<std::uint8_t>(if_not), value});
    }

    void load(std::size_t place) {
        step(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(place), 0, 0);
    }

    void only_if(long call, int argument, int test, std::uint32_t value, std::uint32_t what) {
        step(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(call), 0, 4);
        load(offsetof(seccomp_data, args) + sizeof(std::uint64_t) * std::size_t(argument));
        step(BPF_JMP | test | BPF_K, value, 0, 1);
        answer(what);
        load(offsetof(seccomp_data, nr));
    }

    std::vector<sock_filter> steps_;
};

Filter filter_of_worker(bool libraries) {
    Filter filter;
    // Its channel, its memory, its own threads and signals, the time, and its end.
    filter.each({SYS_read, SYS_write, SYS_readv, SYS_writev, SYS_close, SYS_lseek}, allow);
    filter.each({SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap, SYS_mprotect, SYS_madvise}, allow);
    filter.each({SYS_futex, SYS_set_tid_address, SYS_set_robust_list, SYS_rseq, SYS_sched_yield,
                 SYS_gettid, SYS_getpid},
                allow);
    filter.each({SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack}, allow);
    filter.each({SYS_clock_gettime, SYS_clock_getres, SYS_gettimeofday, SYS_nanosleep,
                 SYS_clock_nanosleep, SYS_restart_syscall, SYS_getrandom},
                allow);
    filter.each({SYS_fstat, SYS_exit, SYS_exit_group}, allow);
    filter.if_argument_is(SYS_tgkill, 0, std::uint32_t(getpid()), allow);  // abort
    filter.if_argument_has(SYS_clone, 0, CLONE_THREAD, allow);
    filter.each({SYS_clone3}, refuse(ENOSYS));  // its flags are in memory: back to clone
    // The step into the worker itself; Landlock knows no other program.
    filter.if_argument_has(SYS_execveat, 4, AT_EMPTY_PATH, allow);
#if defined(__x86_64__)
    constexpr int set_thread_pointer = 0x1002;
    filter.if_argument_is(SYS_arch_prctl, 0, set_thread_pointer, allow);
    filter.each({SYS_arch_prctl, SYS_time, SYS_open, SYS_stat, SYS_access, SYS_readlink, SYS_poll},
                refuse(EACCES));
#endif
    // What a library, or a forgotten line of debugging, tries: it need not cost a case.
    if (libraries) filter.each({SYS_openat, SYS_pread64, SYS_newfstatat}, allow);
    filter.each({SYS_openat,
                 SYS_newfstatat,
                 SYS_statx,
                 SYS_faccessat,
                 SYS_readlinkat,
                 SYS_ioctl,
                 SYS_fcntl,
                 SYS_uname,
                 SYS_sysinfo,
                 SYS_prctl,
                 SYS_prlimit64,
                 SYS_getuid,
                 SYS_geteuid,
                 SYS_getgid,
                 SYS_getegid,
                 SYS_getppid,
                 SYS_sched_getaffinity,
                 SYS_getrusage,
                 SYS_getcwd,
                 SYS_ppoll},
                refuse(EACCES));
    filter.answer(end_process);
    return filter;
}

Filter filter_of_compiler() {
    Filter filter;
    const std::uint32_t refused = refuse(EPERM);
    filter.each({SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_sendto, SYS_sendmsg},
                refused);
    filter.each({SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kill, SYS_tkill,
                 SYS_rt_sigqueueinfo, SYS_pidfd_open, SYS_pidfd_getfd, SYS_pidfd_send_signal},
                refused);
    filter.each({SYS_mount, SYS_umount2, SYS_unshare, SYS_setns, SYS_chroot, SYS_pivot_root,
                 SYS_open_by_handle_at, SYS_mknodat},
                refused);
    filter.each({SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_io_uring_setup, SYS_keyctl,
                 SYS_add_key, SYS_request_key, SYS_personality},
                refused);
    filter.each({SYS_clock_settime, SYS_settimeofday, SYS_adjtimex, SYS_clock_adjtime, SYS_reboot,
                 SYS_swapon, SYS_init_module, SYS_finit_module, SYS_kexec_load},
                refused);
    filter.if_argument_has(SYS_clone, 0,
                           CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWNET | CLONE_NEWIPC,
                           refused);
    filter.each({SYS_clone3}, refuse(ENOSYS));
    filter.answer(allow);
    return filter;
}

}  // namespace

bool filter_system_calls(const Seal& seal) {
    const bool worker = seal.work == Work::answering;
    return (worker ? filter_of_worker(seal.libraries) : filter_of_compiler()).put_on();
}

}  // namespace rt::grade
