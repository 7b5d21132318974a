// Tests of a sandbox that lacks a layer, of the kernel or of the user: nothing starts unsealed.
#include "common/course/grade/sandbox/layers.hpp"
#include "common/course/grade/sandbox/seal.hpp"
#include "tests/grading/seal_ground.hpp"
#include "tests/kit/catch.hpp"

#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>

using namespace rt;

namespace {

/// The function's result in a process to which the kernel refuses this system call, and
/// prctl(PR_SET_SECCOMP) with seccomp.
template <class Function>
int without(long call, int error, Function function) {
    const pid_t process = fork();
    if (process == 0) {
        sock_filter steps[] = {
            {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
            {BPF_JMP | BPF_JEQ | BPF_K, 4, 0, unsigned(call)},
            {BPF_JMP | BPF_JEQ | BPF_K, 0, 2, call == SYS_seccomp ? SYS_prctl : unsigned(call)},
            {BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, args)},
            {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, PR_SET_SECCOMP},
            {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
            {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | unsigned(error)},
        };
        const sock_fprog program{std::size(steps), steps};
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
        _exit(function());
    }
    int answer = 0;
    waitpid(process, &answer, 0);
    return exit_status(answer);
}

/// The same in a process without root's capabilities.
template <class Function>
int without_capability(unsigned capability, Function function) {
    const pid_t process = fork();
    if (process == 0) {
        __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
        __user_cap_data_struct had[2]{};
        if (syscall(SYS_capget, &header, had) != 0) _exit(99);
        had[0].effective &= ~(1U << capability);
        had[0].permitted &= ~(1U << capability);
        if (syscall(SYS_capset, &header, had) != 0) _exit(99);
        _exit(function());
    }
    int answer = 0;
    waitpid(process, &answer, 0);
    return exit_status(answer);
}

}  // namespace

TEST_CASE("without Landlock nothing is compiled, and a worker reaches no file all the same") {
    const Ground ground;
    const Words secret{"read", ground.folder / "secret"};
    for (const Who& who : everybody(ground)) {
        INFO(who.name);
        const auto answered = [&](const Words& limits, const Words& attack) {
            return without(SYS_landlock_create_ruleset, ENOSYS,
                           [&] { return status(ground, who, limits, attack); });
        };
        CHECK(answered({"work=building"}, {"nothing"}) == grade::not_sealed);
        CHECK(answered({}, {"nothing"}) == done);
        CHECK(answered({}, secret) == refused);
    }
    CHECK(without(SYS_landlock_create_ruleset, ENOSYS,
                  [] { return int(grade::hold(grade::layers())); }) == 0);
}

TEST_CASE("without namespaces all required layers work, and without a filter nothing starts") {
    const Ground ground;
    const std::string scratch = ground.folder / "scratch";
    const Words limits{"work=building", "write=" + scratch,
                       "read=" + (ground.folder / "attacker").string()};
    for (const Who& who : everybody(ground)) {
        INFO(who.name);
        const auto answered = [&](const Words& how) {
            return without(SYS_seccomp, EPERM,
                           [&] { return status(ground, who, how, {"nothing"}); });
        };
        if (!who.before.empty() && who.before.back() == "--no-namespaces") continue;
        CHECK(answered({}) == grade::not_sealed);
        CHECK(answered(limits) == grade::not_sealed);
    }
    CHECK(without(SYS_unshare, EPERM, [] { return int(grade::hold(grade::layers())); }) == 1);
    CHECK(without(SYS_seccomp, EPERM, [] { return int(grade::hold(grade::layers())); }) == 0);
}

TEST_CASE(
    "a root without the right to change users gets the missing capabilities, and nothing is "
    "graded") {
    if (geteuid() != 0) return;
    const auto of_layers = [](auto says) {
        return without_capability(CAP_SETUID, [&] { return int(says(grade::layers())); });
    };
    CHECK(of_layers([](const auto& layers) { return grade::hold(layers); }) == 0);
    CHECK(of_layers([](const auto& layers) {
              return std::ranges::any_of(layers, [](const grade::Layer& layer) {
                  return !layer.holds && layer.name ==
                                             "a user of its own for each process: this "
                                             "root lacks CAP_SETUID";
              });
          }) == 1);
}

TEST_CASE("a program that cannot be sealed is not started") {
    const Ground ground;
    const Who grader;
    CHECK(run(ground, grader, {"memory=lots"}, {"nothing"}).output ==
          "error: not sealed: not a number: lots\n");
    CHECK(status(ground, grader, {"color=red"}, {"nothing"}) == grade::not_sealed);
    const ProcessResult missing =
        run_captured({ground.folder / "sealed", "--", "/no/such/program"}, std::chrono::seconds(5));
    CHECK(missing.status == grade::not_sealed);
    CHECK(missing.output == "error: not sealed: /no/such/program: No such file or directory\n");
}
