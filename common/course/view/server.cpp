#include "common/course/view/server.hpp"

#include "common/system/descriptors.hpp"
#include "common/system/input_error.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace rt {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_connections = 24;  // a page has one open, and requests three more at a time
constexpr int most_waiting = 32;
constexpr std::size_t longest_head = 8192;
constexpr std::chrono::seconds patience_with_request{5};
constexpr std::chrono::seconds patience_with_reader{10};

/// A connection, and a pipe: when its other end is closed, all waiting ends. (On macOS, shutdown of
/// the listening socket would end nothing.)
struct Connection {
    int socket = -1;
    int ended = -1;
};

/// True if the connection is ready before the deadline.
bool wait_for(Connection connection, short event, Clock::time_point deadline) {
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        std::array<pollfd, 2> questions{{{connection.socket, event, 0}, {connection.ended, 0, 0}}};
        const int ready = poll(questions.data(), 2, int(std::max<long long>(left.count(), 0)));
        if (ready != -1 || errno != EINTR) return ready > 0 && questions[0].revents != 0;
    }
}

std::string receive_head(Connection connection) {
    const Clock::time_point deadline = Clock::now() + patience_with_request;
    std::string head;
    std::array<char, 1024> received{};
    for (;;) {
        if (!wait_for(connection, POLLIN, deadline)) throw Refusal{408, "too slow"};
        const ssize_t count = recv(connection.socket, received.data(), received.size(), 0);
        if (count <= 0) throw Refusal{400, "malformed request"};
        head.append(received.data(), std::size_t(count));
        const std::size_t end = head.find("\r\n\r\n");
        if (end != std::string::npos) return head.substr(0, end);
        if (head.size() > longest_head) throw Refusal{431, "too long"};
    }
}

void send_all(Connection connection, const std::string& bytes) {
    const Clock::time_point deadline = Clock::now() + patience_with_reader;
    for (std::size_t sent = 0; sent < bytes.size();) {
        if (!wait_for(connection, POLLOUT, deadline)) return;
        // A reader who disconnected must not end the program, as SIGPIPE would.
        const ssize_t count = send(connection.socket, bytes.data() + sent, bytes.size() - sent,
                                   send_without_signal | MSG_DONTWAIT);
        if (count == -1 && errno != EAGAIN && errno != EINTR) return;
        if (count > 0) sent += std::size_t(count);
    }
}

/// Closes without losing sent bytes, as unread input would cause.
void close_kindly(Connection connection) {
    shutdown(connection.socket, SHUT_WR);
    const Clock::time_point deadline = Clock::now() + std::chrono::milliseconds(200);
    std::array<char, 4096> unread{};
    while (wait_for(connection, POLLIN, deadline) &&
           recv(connection.socket, unread.data(), unread.size(), 0) > 0 && Clock::now() < deadline)
        continue;
    close(connection.socket);
}

/// The next connection of a listening socket that does not block; -1 if there is none.
int accept_connection(int listener) {
    const std::scoped_lock lock(inheritance);
    const int socket = accept(listener, nullptr, nullptr);
    if (socket == -1) return -1;
    fcntl(socket, F_SETFL, 0);  // on macOS, it does not block either
    return prepare_socket(socket);
}

}  // namespace

Server::Server(int port) {
    listener_ = keep_from_children(socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    const int yes = 1;
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    auto* const generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (listener_ == -1 || bind(listener_, generic, size) != 0 ||
        listen(listener_, most_waiting) != 0 || getsockname(listener_, generic, &size) != 0) {
        const int why = errno;
        if (listener_ != -1) close(listener_);
        throw InputError({}, "port " + std::to_string(port) +
                                 " of 127.0.0.1 cannot be used: " + std::strerror(why));
    }
    port_ = ntohs(address.sin_port);
    fcntl(listener_, F_SETFL, O_NONBLOCK);
    if (!make_pipe(end_)) {
        close(listener_);
        throw InputError({}, "cannot create a pipe");
    }
}

Server::~Server() {
    stop();
    close(listener_);
    close(end_[0]);
}

void Server::start(const Answer& answer) {
    for (int i = 0; i < most_connections; ++i)
        workers_.emplace_back([this, answer] { work(answer); });
}

void Server::stop() {
    if (end_[1] != -1) close(std::exchange(end_[1], -1));  // ends all waiting
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
}

void Server::work(const Answer& answer) const {
    for (;;) {
        std::array<pollfd, 2> questions{{{listener_, POLLIN, 0}, {end_[0], 0, 0}}};
        if (poll(questions.data(), 2, -1) == -1) continue;
        if (questions[1].revents != 0) return;
        const int socket = accept_connection(listener_);
        if (socket == -1) {
            // Another thread was faster, or the client disconnected; or a resource is exhausted.
            if (errno != EAGAIN) std::this_thread::sleep_for(std::chrono::milliseconds(50));
            continue;
        }
        const Connection connection{socket, end_[0]};
        send_all(connection, to_bytes(respond([&] { return receive_head(connection); }, answer)));
        close_kindly(connection);
    }
}

void Server::check_host(const Request& request) const {
    const std::string suffix = ":" + std::to_string(port_);
    if (request.host != "127.0.0.1" + suffix && request.host != "localhost" + suffix)
        throw Refusal{403, "requests are accepted from this machine only"};
}

Response Server::respond(const std::function<std::string()>& head, const Answer& answer) const {
    try {
        const Request request = parse_request(head());
        check_host(request);
        return answer(request);
    } catch (const Refusal& refusal) {
        return {.status = refusal.status, .body = refusal.reason + "\n"};
    } catch (const std::exception& error) {
        return {.status = 500, .body = std::string(error.what()) + "\n"};
    }
}

}  // namespace rt
