// The end of a sealed process, and of its children.
#include "tests/grading/seal_ground.hpp"
#include "tests/kit/catch.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <tuple>

using namespace rt;

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
