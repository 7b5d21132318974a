// Tests of the processes that programs leave running. tests/programs/course_test.sh runs the rest
// of process.hpp.
#include "common/system/process.hpp"
#include "tests/kit/catch.hpp"

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#ifdef __linux__

namespace {

/// The process whose number is the program's output.
pid_t left_by(const std::string& script, const std::atomic<bool>* cancelled = nullptr) {
    const rt::ProcessResult ending =
        rt::run_captured({"sh", "-c", script}, std::chrono::seconds(20), cancelled);
    CHECK(ending.status == 0);
    return std::atoi(ending.output.c_str());
}

bool is_running(pid_t process) {
    return kill(process, 0) == 0;
}

}  // namespace

TEST_CASE("a process that a program leaves running is ended with it") {
    const std::atomic<bool> cancelled = false;
    for (const std::atomic<bool>* own_group :
         {static_cast<const std::atomic<bool>*>(nullptr), &cancelled}) {
        for (const char* script : {"sleep 100 & echo $!", "setsid sleep 100 > /dev/null & echo $!",
                                   "(sleep 100 > /dev/null & echo $!)"}) {
            INFO(script);
            const pid_t left = left_by(script, own_group);
            REQUIRE(left > 0);
            CHECK_FALSE(is_running(left));
            if (is_running(left)) kill(left, SIGKILL);
        }
    }
}

TEST_CASE("time in which the caller is stopped is not the program's") {
    // The limit is a second. The program sleeps for half of one, and is stopped with its caller, or
    // goes on alone; both are stopped for two.
    for (const bool with_the_program : {false, true}) {
        INFO("with the program: " << with_the_program);
        const pid_t caller = fork();
        if (caller == 0) {
            setpgid(0, 0);
            const rt::ProcessResult ending =
                rt::run_captured({"sleep", "0.5"}, std::chrono::seconds(1));
            _exit(ending.out_of_time ? 1 : ending.status);
        }
        usleep(200000);
        const pid_t stopped = with_the_program ? -caller : caller;
        kill(stopped, SIGSTOP);
        usleep(2000000);
        kill(stopped, SIGCONT);
        int status = -1;
        waitpid(caller, &status, 0);
        CHECK(status == 0);
    }
}

TEST_CASE(
    "a program's processor time is that of its children, too, and not the time of its sleep") {
    const auto used = [](const std::string& script) {
        return rt::run_captured({"sh", "-c", script}, std::chrono::seconds(60)).processor_seconds;
    };
    CHECK(used("sleep 0.5") < 0.3);
    const std::string spin = "i=0; while [ $i -lt 300000 ]; do i=$((i + 1)); done";
    CHECK(used("(" + spin + ")\ntrue") > 10 * used("(exit 0)\ntrue"));
}

TEST_CASE("what else is running goes on when a program ends") {
    // A program of another thread.
    int status = -1;
    std::thread other([&] { status = rt::run_process({"sleep", "0.5"}); });
    (void)left_by("sleep 100 & echo $!");
    other.join();
    CHECK(status == 0);

    // A child from before.
    rt::ProcessResult later;
    std::string before;
    CHECK(rt::run_heard({"sh", "-c", "sleep 1 > /dev/null & echo $!"}, rt::Streams::output,
                        [&](std::string_view piece) { before += piece; }) == 0);
    (void)left_by("sleep 100 & echo $!");
    CHECK(is_running(std::atoi(before.c_str())));
}

#endif
