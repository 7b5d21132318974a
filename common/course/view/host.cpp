#include "common/course/view/server.hpp"

#include "common/system/descriptors.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <random>

namespace rt {

namespace {

/// A secret that only readers of the terminal know, as part of the address.
std::string make_token() {
    std::random_device random;
    std::string token;
    for (int i = 0; i < 4; ++i) token += formatted("%08x", random());
    return token;
}

// Ctrl-C is sent through a pipe: a signal handler may do little else than write to one.
int end_wanted = -1;

void on_signal(int /*signal*/) {
    const int error = errno;
    [[maybe_unused]] const ssize_t one = write(end_wanted, "", 1);
    errno = error;
}

/// From now on, a request to end can be read from the returned descriptor.
int hear_signals() {
    std::array<int, 2> ends{};
    if (!make_pipe(ends)) throw InputError({}, "cannot create a pipe");
    end_wanted = ends[1];
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
    return ends[0];
}

void wait_for_signal(int heard) {
    char none = 0;
    while (read(heard, &none, 1) == -1 && errno == EINTR) continue;
}

}  // namespace

Host::Host(int port) : heard_(hear_signals()), server_(port) {}

void Host::serve(const std::string& first_page, const Server::Answer& answer,
                 const std::function<void()>& stop) {
    const std::string start = "/" + make_token() + "/";
    server_.start([&](const Request& request) {
        if (request.path.rfind(start, 0) != 0)
            throw Refusal{403, "the address is not the one on the terminal"};
        Request rest = request;
        rest.path.erase(0, start.size());
        return answer(rest);
    });
    print_line("http://127.0.0.1:" + std::to_string(server_.port()) + start + first_page);
    print_line(tr("Only this machine can open the page. Ctrl-C ends it."));
    std::fflush(stdout);
    wait_for_signal(heard_);
    stop();
    server_.stop();
}

}  // namespace rt
