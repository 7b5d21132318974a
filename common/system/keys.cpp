#include "common/system/keys.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>
#include <thread>

namespace rt {

namespace {

constexpr auto ending_signals = {SIGINT, SIGTERM, SIGHUP};

termios before;

/// A program in the background would be stopped if it changed the terminal.
bool is_in_foreground() {
    return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

void restore() {
    if (is_in_foreground()) tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

void restore_and_end(int signal) {
    restore();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// Also after a shell has had the terminal.
void read_one_by_one() {
    if (!is_in_foreground()) return;
    termios now = before;
    now.c_lflag &= ~tcflag_t(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

void go_on(int /*signal*/) {
    read_one_by_one();
}

/// Ctrl-Z: stops here, until SIGCONT.
void restore_and_stop(int signal) {
    restore();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, signal);
    pthread_sigmask(SIG_UNBLOCK, &stops, nullptr);
    std::signal(signal, restore_and_stop);
}

}  // namespace

Keys::Keys() : are_read_(is_in_foreground() && tcgetattr(STDIN_FILENO, &before) == 0) {
    if (!are_read_) return;
    for (const int signal : ending_signals) std::signal(signal, restore_and_end);
    // A shell without job control ignores it.
    if (std::signal(SIGTSTP, restore_and_stop) == SIG_IGN) std::signal(SIGTSTP, SIG_IGN);
    std::signal(SIGCONT, go_on);
    read_one_by_one();
}

Keys::~Keys() {
    if (!are_read_) return;
    restore();
    for (const int signal : ending_signals) std::signal(signal, SIG_DFL);
    for (const int signal : {SIGTSTP, SIGCONT}) std::signal(signal, SIG_DFL);
}

char Keys::pressed(std::chrono::milliseconds within) const {
    if (!are_read_) {
        std::this_thread::sleep_for(within);
        return 0;
    }
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    char key = 0;
    if (poll(&input, 1, int(within.count())) > 0 && read(STDIN_FILENO, &key, 1) == 1) return key;
    return 0;
}

}  // namespace rt
