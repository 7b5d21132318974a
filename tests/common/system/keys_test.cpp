// Tests of keys on a terminal, with a shell's part played by its session's first process.
#include "common/system/keys.hpp"
#include "tests/kit/catch.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

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
