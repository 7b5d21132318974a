// Tests of the processes that programs leave running. tests/programs/course_test.sh runs the rest
// of process.hpp.
#include "common/system/process.hpp"

#include "common/system/files.hpp"
#include "common/system/keys.hpp"
#include "common/system/version.hpp"

#include "tests/kit/catch.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <termios.h>
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

// Tests of keys on a terminal, with a shell's part played by its session's first process.

namespace {

using namespace std::chrono_literals;

/// True if the terminal soon passes whole lines, or keys.
bool becomes(bool lines) {
    for (int i = 0; i < 1000; ++i) {
        termios now{};
        tcgetattr(STDIN_FILENO, &now);
        constexpr tcflag_t both = ICANON | ECHO;
        if ((now.c_lflag & both) == (lines ? both : 0)) return true;
        usleep(10000);
    }
    return false;
}

[[noreturn]] void read_until_q() {
    setpgid(0, 0);
    while (tcgetpgrp(STDIN_FILENO) != getpgrp()) usleep(1000);
    std::signal(SIGTTOU, SIG_DFL);
    bool is_read = false;
    {
        const rt::Keys keys;
        for (int i = 0; i < 200 && !is_read; ++i) is_read = keys.pressed(100ms) == 'q';
    }
    _exit(is_read ? 0 : 1);
}

/// Stops a program by Ctrl-Z and continues it. Returns the number of the check that failed; 0 for
/// none.
int stop_and_continue(int keyboard) {
    std::signal(SIGTTOU, SIG_IGN);
    const pid_t program = fork();
    if (program == 0) read_until_q();
    setpgid(program, program);
    tcsetpgrp(STDIN_FILENO, program);
    int status = 0;
    const auto press = [keyboard](const char* key) { return write(keyboard, key, 1) == 1; };
    const auto failed = [program](int check) {
        kill(program, SIGKILL);
        return check;
    };
    if (!becomes(false)) return failed(1);
    if (!press("\x1a")) return failed(2);
    if (waitpid(program, &status, WUNTRACED) != program || !WIFSTOPPED(status)) return failed(3);
    if (!becomes(true)) return failed(4);
    kill(-program, SIGCONT);
    if (!becomes(false)) return failed(5);
    if (!press("q")) return failed(6);
    if (waitpid(program, &status, 0) != program || status != 0) return failed(7);
    return becomes(true) ? 0 : 8;
}

}  // namespace

TEST_CASE("Ctrl-Z leaves the terminal as it was, and keys are read again after it") {
    const int keyboard = posix_openpt(O_RDWR | O_NOCTTY);
    if (keyboard == -1 || grantpt(keyboard) != 0 || unlockpt(keyboard) != 0)
        return;  // no terminals
    const pid_t shell = fork();
    if (shell == 0) {
        setsid();
        dup2(open(ptsname(keyboard), O_RDWR), STDIN_FILENO);
        ioctl(STDIN_FILENO, TIOCSCTTY, 0);
        _exit(stop_and_continue(keyboard));
    }
    int status = 0;
    REQUIRE(waitpid(shell, &status, 0) == shell);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    close(keyboard);
}

// The version that programs print.

using namespace rt;

TEST_CASE("a version names the commit of a clone, or the one of which a hand-out was made") {
    const TemporaryFolder folder;
    const auto& project = folder.path();
    CHECK(version(project) == version_number());
    write_text(project / ".git/HEAD", "ref: refs/heads/main\n");
    write_text(project / ".git/packed-refs", "# pack-refs\n0123456789abcdef refs/heads/main\n");
    CHECK(version(project) == version_number() + " (0123456)");
    write_text(project / ".git/refs/heads/main", "89abcdef01234567\n");
    CHECK(version(project) == version_number() + " (89abcde)");

    // A student's commit is none of the project's.
    const auto manifest = project / "steps/handout.txt";
    write_text(manifest,
               "Raysteps, version 1.0.0 (52c7ed4), handed out on 2026-11-21 for g++ (12)\n");
    CHECK(version(project) == version_number() + " (52c7ed4)");
    write_text(manifest, "Raysteps, version 1.0.0, handed out on 2026-11-21 for g++ (12)\n");
    CHECK(version(project) == version_number());
    write_text(manifest, "Raysteps, half updated: run ./course update again\n");
    CHECK(version(project) == version_number());
}
