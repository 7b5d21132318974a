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

void restore() {
    tcsetattr(STDIN_FILENO, TCSANOW, &before);
}

void restore_and_end(int signal) {
    restore();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// A program in the background would be stopped if it changed the terminal.
bool is_in_foreground() {
    return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

}  // namespace

Keys::Keys() : are_read_(is_in_foreground() && tcgetattr(STDIN_FILENO, &before) == 0) {
    if (!are_read_) return;
    for (const int signal : ending_signals) std::signal(signal, restore_and_end);
    termios now = before;
    now.c_lflag &= ~tcflag_t(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &now);
}

Keys::~Keys() {
    if (!are_read_) return;
    restore();
    for (const int signal : ending_signals) std::signal(signal, SIG_DFL);
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
