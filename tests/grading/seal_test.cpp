// Attacks on each layer of the sandbox.
#include "common/course/grade/sandbox/seal.hpp"

#include "common/course/grade/sandbox/layers.hpp"

#include "tests/grading/seal_ground.hpp"
#include "tests/kit/catch.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <tuple>

using namespace rt;

TEST_CASE("the seal's required layers work on this machine") {
    for (const grade::Layer& layer : grade::layers()) {
        INFO(layer.name);
        CHECK((layer.holds || !layer.needed));
    }
}

TEST_CASE("a missing required layer is reported, and nothing is graded") {
    CHECK(grade::hold({{"one", true, true}, {"two", false, false}}));
    CHECK_FALSE(grade::hold({{"one", false, true}, {"two", true, false}}));
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
        CHECK(status(ground, who, {}, {"own clocks"}) == done);
        CHECK(status(ground, who, {}, {"clock of another"}) == ended);
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
        CHECK(status(ground, who, limits, {"own clocks"}) == done);
        CHECK(status(ground, who, limits, {"clock of another"}) == refused);
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
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
        CHECK(status(ground, who, limits, {"daemon", scratch + "/late"}) == done);
        usleep(1500000);
        CHECK_FALSE(fs::exists(scratch + "/late"));
        CHECK(processes_of(ground.folder / "attacker") == 0);
        fs::remove(scratch + "/made");
    }
}

TEST_CASE("a tool gets a file as its input that its user may not open") {
    const Ground ground;
    const fs::path file = ground.folder / "submission";
    std::ofstream(file) << "archive";
    fs::permissions(file, fs::perms(0600));
    Words limits{"work=building", "wall=60", "write=" + (ground.folder / "scratch").string(),
                 "read=" + (ground.folder / "attacker").string()};
    const Who me = everybody(ground).front();
    CHECK(status(ground, me, limits, {"input"}) == refused);
    limits.push_back("input=" + file.string());
    CHECK(status(ground, me, limits, {"input"}) == done);
}

TEST_CASE("a compiler does not learn which files exist in the folders of people and services") {
    const Ground ground;
    if (!grade::layers().back().holds || ground.folder.string().starts_with("/var/")) return;
    const Words limits{"work=building", "wall=60", "write=" + (ground.folder / "scratch").string(),
                       "read=" + (ground.folder / "attacker").string()};
    REQUIRE(fs::exists("/var/lib"));
    const Who me = everybody(ground).front();
    CHECK(status(ground, me, limits, {"see", "/var/lib"}) == refused);
    CHECK(status(ground, me, limits, {"see", ground.folder / "attacker"}) == done);
    Words with_it = limits;
    with_it.emplace_back("read=/var/lib");
    CHECK(status(ground, me, with_it, {"see", "/var/lib"}) == done);
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

// The end of a sealed process, and of its children.

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
            CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
            CHECK(soon([&] { return processes_of(attacker) == 0; }));
        }
    }
}

TEST_CASE("time in which a tool is stopped with the one that watches it is not its own") {
    const Ground ground;
    const Command command =
        sealed(ground, everybody(ground).front(),
               {"work=building", "wall=1", "write=" + (ground.folder / "scratch").string(),
                "read=" + (ground.folder / "attacker").string()},
               {"nap"});
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t watcher = fork();
    if (watcher == 0) {
        execv(words[0], words.data());
        _exit(99);
    }
    const auto tool = [watcher] {
        const std::string me = std::to_string(watcher);
        std::ifstream children("/proc/" + me + "/task/" + me + "/children");
        pid_t child = 0;
        children >> child;
        return child;
    };
    while (tool() == 0 && kill(watcher, 0) == 0) usleep(1000);
    const std::array<pid_t, 2> both{watcher, tool()};
    for (const pid_t each : both) kill(each, SIGSTOP);
    usleep(2000000);
    for (const pid_t each : both) kill(each, SIGCONT);
    int status = -1;
    waitpid(watcher, &status, 0);
    CHECK(status == done);
}
