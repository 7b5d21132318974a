// Attacks on each layer of the sandbox: by the user of the test, and, if that is root, by an
// ordinary user too.
#include "common/course/grade/sandbox/seal.hpp"
#include "common/course/grade/sandbox/layers.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include "tests/kit/catch.hpp"

#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <tuple>

using namespace rt;
namespace fs = std::filesystem;

namespace {

constexpr int done = 0;
constexpr int refused = 1;
constexpr int ended = 128 + SIGSYS;

using Words = std::vector<std::string>;

/// A folder that everyone may enter, with the programs in it.
struct Ground {
    Ground() {
        fs::permissions(folder, fs::perms(0755));
        fs::copy_file(RAYSTEPS_SEALED, folder / "sealed");
        fs::copy_file(RAYSTEPS_ATTACKER, folder / "attacker");
        fs::copy_file(RAYSTEPS_ATTACKER, folder / "launcher");  // not counted as an attack
        fs::create_directory(folder / "scratch");
        fs::permissions(folder / "scratch", fs::perms(0777));
        std::ofstream(folder / "secret") << "expected values";
        fs::permissions(folder / "secret", fs::perms(0666));
    }

    TemporaryFolder temporary;
    const fs::path& folder = temporary.path();
};

/// An attacking user: the grader's own, or an ordinary one; with and without namespaces in the
/// kernel.
struct Who {
    std::string name;
    Words before;
};

/// A user without other processes: the limit on processes counts all of a user's, also those of
/// another test.
const uid_t ordinary_user = 50000 + uid_t(getpid()) % 10000;

bool is_ordinary(const Who& who) {
    return geteuid() != 0 || (!who.before.empty() && who.before[0] == "setpriv");
}

std::vector<Who> everybody(const Ground& ground) {
    std::vector<Who> all{{"whoever runs this", {}}};
    const std::string user = std::to_string(ordinary_user);
    if (geteuid() == 0)
        all.push_back({"an ordinary user",
                       {"setpriv", "--reuid=" + user, "--regid=" + user, "--clear-groups"}});
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        Who who = all[i];
        who.name += ", without namespaces";
        who.before.insert(who.before.end(), {ground.folder / "launcher", "--no-namespaces"});
        all.push_back(who);
    }
    return all;
}

Command sealed(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    Command command = who.before;
    command.push_back(ground.folder / "sealed");
    command.insert(command.end(), limits.begin(), limits.end());
    command.insert(command.end(), {"--", ground.folder / "attacker"});
    command.insert(command.end(), attack.begin(), attack.end());
    return command;
}

ProcessResult run(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    return run_captured(sealed(ground, who, limits, attack), std::chrono::seconds(60));
}

int status(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    return run(ground, who, limits, attack).status;
}

/// The number of processes of a program.
int processes_of(const fs::path& program) {
    int count = 0;
    for (const auto& each : fs::directory_iterator("/proc")) {
        std::ifstream in(each.path() / "cmdline");
        std::string line;
        std::getline(in, line, '\0');
        count += line == program.string();
    }
    return count;
}

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

TEST_CASE("the seal's required layers work on this machine") {
    const auto layers = grade::layers();
    INFO(grade::text_of(layers));
    CHECK(grade::hold(layers));
}

TEST_CASE("a missing required layer is reported, and nothing is graded") {
    CHECK(grade::hold({{"one", true, true}, {"two", false, false}}));
    CHECK_FALSE(grade::hold({{"one", false, true}, {"two", true, false}}));
    CHECK(grade::text_of({{"one", false, true}, {"two", true, false}}) == "✗ one\n✓ two\n");
}

TEST_CASE("a worker computes, has threads, and can end as it likes") {
    const Ground ground;
    for (const Who& who : everybody(ground)) {
        INFO(who.name);
        CHECK(status(ground, who, {}, {"nothing"}) == done);
        CHECK(status(ground, who, {}, {"threads"}) == done);
        CHECK(status(ground, who, {}, {"abort"}) == 128 + SIGABRT);
        CHECK(run(ground, who, {}, {"print"}).output.empty());
    }
}

TEST_CASE("a caller that may write no core file can start a worker") {
    const Ground ground;
    for (Who grader : everybody(ground)) {
        INFO(grader.name);
        grader.before.insert(grader.before.begin(), {"prlimit", "--core=0:0"});
        CHECK(status(ground, grader, {}, {"nothing"}) == done);
    }
}

TEST_CASE("a worker reaches no file, process or network, whoever grades") {
    const Ground ground;
    const std::string secret = ground.folder / "secret";
    setenv("SECRET", "1", 1);
    for (const Who& who : everybody(ground)) {
        INFO(who.name);
        CHECK(status(ground, who, {}, {"read", secret}) == refused);
        CHECK(status(ground, who, {}, {"write", secret}) == refused);
        CHECK(status(ground, who, {}, {"socket"}) == ended);
        CHECK(status(ground, who, {}, {"fork"}) == ended);
        CHECK(status(ground, who, {}, {"exec"}) == ended);
        CHECK(status(ground, who, {}, {"exec another way"}) == ended);
        CHECK(status(ground, who, {}, {"exec beside", "/bin/true"}) == refused);
        CHECK(status(ground, who, {}, {"wait for a thread"}) == ended);
        CHECK(status(ground, who, {}, {"trace"}) == ended);
        CHECK(status(ground, who, {}, {"signal"}) == ended);
        CHECK(status(ground, who, {}, {"set the clock"}) == ended);
        CHECK(status(ground, who, {}, {"namespaces"}) == ended);
        CHECK(status(ground, who, {}, {"root"}) == ended);
        CHECK(status(ground, who, {}, {"descriptors"}) == refused);
        CHECK(status(ground, who, {}, {"environment"}) == refused);
    }
}

TEST_CASE("time, memory and threads have an end") {
    const Ground ground;
    for (const Who& who : everybody(ground)) {
        INFO(who.name);
        CHECK(status(ground, who, {"memory=512"}, {"memory"}) == refused);
        CHECK(status(ground, who, {"memory=4096"}, {"memory"}) == done);
        CHECK(status(ground, who, {"threads=32"}, {"many threads"}) == refused);
        CHECK(status(ground, who, {"threads=400"}, {"many threads"}) == done);
        CHECK(status(ground, who, {"cpu=1"}, {"spin"}) == 128 + SIGXCPU);
    }
}

TEST_CASE("a compiler reads and writes only in the given folders, and leaves no process behind") {
    const Ground ground;
    const std::string secret = ground.folder / "secret";
    const std::string scratch = ground.folder / "scratch";
    const Words limits{"work=building", "wall=2", "file=1", "write=" + scratch,
                       "read=" + (ground.folder / "attacker").string()};
    const std::string me = std::to_string(getpid());
    for (const Who& who : everybody(ground)) {
        // As root, the folder is owned by the compiler's user.
        if (geteuid() == 0 && is_ordinary(who))
            REQUIRE(chown(scratch.c_str(), ordinary_user, ordinary_user) == 0);
        INFO(who.name);
        CHECK(status(ground, who, limits, {"nothing"}) == done);
        CHECK(run(ground, who, limits, {"print"}).output == "printedtoo");
        CHECK(status(ground, who, limits, {"write", scratch + "/made"}) == done);
        CHECK(status(ground, who, limits, {"read", secret}) == refused);
        CHECK(status(ground, who, limits, {"write", secret}) == refused);
        CHECK(status(ground, who, limits, {"read", "/dev/zero"}) == refused);
        CHECK(status(ground, who, limits, {"read", "/etc/passwd"}) == refused);
        CHECK(status(ground, who, limits, {"read", "/proc/self/maps"}) == refused);
        CHECK(status(ground, who, limits, {"socket"}) == refused);
        CHECK(status(ground, who, limits, {"trace"}) == refused);
        CHECK(status(ground, who, limits, {"signal", me}) == refused);
        CHECK(status(ground, who, limits, {"namespaces"}) == refused);
        CHECK(status(ground, who, limits, {"environment"}) == refused);
        CHECK(status(ground, who, limits, {"leave the group"}) == refused);
        CHECK(status(ground, who, limits, {"signal by a pipe"}) == refused);
        CHECK(status(ground, who, limits, {"priority"}) == refused);
        CHECK(status(ground, who, limits, {"core"}) == refused);
        CHECK(status(ground, who, limits, {"change mode", secret}) == done);  // it thinks
        CHECK(fs::status(secret).permissions() == fs::perms(0666));
        const auto start = std::chrono::steady_clock::now();
        CHECK(status(ground, who, limits, {"sleep"}) == 128 + SIGXCPU);
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
        CHECK(status(ground, who, limits, {"daemon", scratch + "/late"}) == done);
        usleep(1500000);
        CHECK_FALSE(fs::exists(scratch + "/late"));
        CHECK(processes_of(ground.folder / "attacker") == 0);
        fs::remove(scratch + "/made");
    }
}

TEST_CASE("a process that ends, for any reason, ends all of its children") {
    const Ground ground;
    const std::string scratch = ground.folder / "scratch";
    const Words building{"work=building", "wall=60", "write=" + scratch,
                         "read=" + (ground.folder / "attacker").string()};
    const std::string attacker = ground.folder / "attacker";
    // The attacks sleep for a minute: a condition that becomes true much earlier is not due to
    // their own end.
    const auto soon = [](auto holds) {
        const auto start = std::chrono::steady_clock::now();
        while (!holds()) {
            if (std::chrono::steady_clock::now() - start > std::chrono::seconds(20)) return false;
            usleep(10000);
        }
        return true;
    };
    for (const Who& who : everybody(ground)) {
        if (geteuid() == 0 && is_ordinary(who))
            REQUIRE(chown(scratch.c_str(), ordinary_user, ordinary_user) == 0);
        for (const auto& [limits, attack, count] :
             {std::tuple(building, "children", 3), std::tuple(Words{}, "sleep", 1)}) {
            INFO(who.name + ": " + attack);
            // The grader is killed.
            const Command command = sealed(ground, who, limits, {attack});
            const pid_t grader = fork();
            if (grader == 0) _exit(run_captured(command, std::chrono::seconds(60)).status);
            CHECK(soon([&, all = count] { return processes_of(attacker) == all; }));
            kill(grader, SIGKILL);
            waitpid(grader, nullptr, 0);
            CHECK(soon([&] { return processes_of(attacker) == 0; }));
            // It has reached its limit, and is stopped.
            CHECK(run_captured(command, std::chrono::seconds(1)).out_of_time);
            CHECK(soon([&] { return processes_of(attacker) == 0; }));
            const std::atomic<bool> stop = true;
            const auto start = std::chrono::steady_clock::now();
            CHECK(run_captured(command, std::chrono::seconds(60), &stop).status != done);
            CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
            CHECK(soon([&] { return processes_of(attacker) == 0; }));
        }
    }
}

TEST_CASE("of those that root starts, no two at once are the same user") {
    if (geteuid() != 0) return;
    int ready[2];
    int go[2];
    int answer[2];
    REQUIRE((pipe(ready) == 0 && pipe(go) == 0 && pipe(answer) == 0));
    const pid_t process = fork();
    if (process == 0) {
        char byte = 0;
        if (read(go[0], &byte, 1) != 1 || !grade::take_user_of_its_own({})) _exit(1);
        const uid_t user = getuid();
        _exit(write(answer[1], &user, sizeof user) == sizeof user ? 0 : 1);
    }
    // The next user id in turn already has processes.
    const uid_t taken = 61184 + uid_t(process) % 4000;
    const pid_t other = fork();
    if (other == 0) {
        if (setresuid(taken, taken, taken) != 0 || write(ready[1], "", 1) != 1) _exit(1);
        pause();
    }
    char byte = 0;
    REQUIRE((read(ready[0], &byte, 1) == 1 && write(go[1], "", 1) == 1));
    uid_t user = 0;
    CHECK(read(answer[0], &user, sizeof user) == sizeof user);
    CHECK(user != 0);
    CHECK(user != taken);
    kill(other, SIGKILL);
    waitpid(other, nullptr, 0);
    waitpid(process, nullptr, 0);
    for (const int each : {ready[0], ready[1], go[0], go[1], answer[0], answer[1]}) close(each);
}

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
              return grade::text_of(layers).find(
                         "✗ a user of its own for each process: this root "
                         "lacks CAP_SETUID\n") != std::string::npos;
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
