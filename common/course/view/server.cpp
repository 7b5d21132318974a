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
#include <optional>
#include <utility>

namespace rt {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_answers = 24;  // at a time: a page waits for one, and requests three more
constexpr std::size_t most_visitors = 256;
constexpr int most_in_kernel = 128;  // not accepted yet
constexpr std::size_t longest_head = 8192;
constexpr std::chrono::seconds patience_with_request{5};
constexpr std::chrono::seconds patience_with_reader{10};
constexpr std::chrono::milliseconds patience_while_others_wait{250};  ///< for each piece

/// A connection, and a pipe: when its other end is closed, all waiting ends. (On macOS, shutdown of
/// the listening socket would end nothing.)
struct Connection {
    int socket = -1;
    int ended = -1;
};

/// The milliseconds until a deadline, for poll.
int milliseconds_until(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    return int(std::max<long long>(left.count(), 0));
}

/// True if the connection is ready before the deadline.
bool wait_for(Connection connection, short event, Clock::time_point deadline) {
    for (;;) {
        std::array<pollfd, 2> questions{{{connection.socket, event, 0}, {connection.ended, 0, 0}}};
        const int ready = poll(questions.data(), 2, milliseconds_until(deadline));
        if (ready != -1 || errno != EINTR) return ready > 0 && questions[0].revents != 0;
    }
}

/// Sends all bytes, or gives up a reader who is too slow.
void send_all(Connection connection, const std::string& bytes,
              const std::function<bool()>& others_wait) {
    const Clock::time_point deadline = Clock::now() + patience_with_reader;
    for (std::size_t sent = 0; sent < bytes.size() && Clock::now() < deadline;) {
        const bool is_ready =
            wait_for(connection, POLLOUT, Clock::now() + patience_while_others_wait);
        if (!is_ready && others_wait()) return;
        if (!is_ready) continue;
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

struct Server::Visitor {
    int socket = -1;
    Clock::time_point deadline;
    std::string head = "";  ///< of the request, up to its empty line
    std::optional<Refusal> refusal = std::nullopt;

    /// Receives what has arrived. Returns whether the head is whole, or refused.
    bool receive() {
        std::array<char, 1024> received{};
        const ssize_t count = recv(socket, received.data(), received.size(), MSG_DONTWAIT);
        if (count == -1 && (errno == EAGAIN || errno == EINTR)) return false;
        if (count <= 0) return refuse(400, "malformed request");
        head.append(received.data(), std::size_t(count));
        const std::size_t end = head.find("\r\n\r\n");
        if (end == std::string::npos) return head.size() > longest_head && refuse(431, "too long");
        head.resize(end);
        return true;
    }

    bool refuse(int status, const std::string& reason) {
        refusal = Refusal{status, reason};
        return true;
    }
};

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
        listen(listener_, most_in_kernel) != 0 || getsockname(listener_, generic, &size) != 0) {
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
    threads_.emplace_back([this] { receive(); });
    for (int i = 0; i < most_answers; ++i) threads_.emplace_back([this, answer] { work(answer); });
}

void Server::stop() {
    if (end_[1] != -1) close(std::exchange(end_[1], -1));  // ends all waiting
    {
        const std::scoped_lock lock(mutex_);
        over_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    for (const Visitor& visitor : queue_) close(visitor.socket);
    queue_.clear();
}

void Server::receive() {
    std::list<Visitor> visitors;  // the oldest first
    for (;;) {
        std::vector<pollfd> questions{{end_[0], 0, 0}, {listener_, POLLIN, 0}};
        for (const Visitor& visitor : visitors) questions.push_back({visitor.socket, POLLIN, 0});
        const int time = visitors.empty() ? -1 : milliseconds_until(visitors.front().deadline);
        if (poll(questions.data(), nfds_t(questions.size()), time) == -1) continue;
        if (questions[0].revents != 0) break;
        auto question = questions.begin() + 2;
        for (auto next = visitors.begin(); next != visitors.end(); ++question) {
            const auto visitor = next++;
            const bool is_ready = question->revents != 0 && visitor->receive();
            const bool is_late = !is_ready && Clock::now() >= visitor->deadline;
            if (is_late) visitor->refuse(408, "too slow");
            if (is_ready || is_late) queue_up(visitors, visitor);
        }
        if (questions[1].revents != 0) accept_one(visitors);
    }
    for (const Visitor& visitor : visitors) close(visitor.socket);
}

/// If there are too many, the oldest has had the most time to send its request.
void Server::accept_one(std::list<Visitor>& visitors) const {
    const int socket = accept_connection(listener_);
    if (socket != -1) {
        visitors.push_back({.socket = socket, .deadline = Clock::now() + patience_with_request});
        if (visitors.size() <= most_visitors) return;
        close(visitors.front().socket);
        visitors.pop_front();
    } else if (errno != EAGAIN && errno != ECONNABORTED) {  // a resource is exhausted
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

void Server::queue_up(std::list<Visitor>& visitors, std::list<Visitor>::iterator visitor) {
    {
        const std::scoped_lock lock(mutex_);
        if (queue_.size() < most_visitors) {
            queue_.splice(queue_.end(), visitors, visitor);
        } else {
            close(visitor->socket);
            visitors.erase(visitor);
        }
    }
    changed_.notify_one();
}

void Server::work(const Answer& answer) {
    for (;;) {
        std::list<Visitor> mine;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return over_ || !queue_.empty(); });
            if (over_) return;
            mine.splice(mine.end(), queue_, queue_.begin());
        }
        const Connection connection{mine.front().socket, end_[0]};
        send_all(connection, to_bytes(respond(mine.front(), answer)), [this] {
            const std::scoped_lock lock(mutex_);
            return over_ || !queue_.empty();
        });
        close_kindly(connection);
    }
}

void Server::check_host(const Request& request) const {
    const std::string suffix = ":" + std::to_string(port_);
    if (request.host != "127.0.0.1" + suffix && request.host != "localhost" + suffix)
        throw Refusal{403, "requests are accepted from this machine only"};
}

Response Server::respond(const Visitor& visitor, const Answer& answer) const {
    try {
        if (visitor.refusal) throw Refusal(*visitor.refusal);
        const Request request = parse_request(visitor.head);
        check_host(request);
        return answer(request);
    } catch (const Refusal& refusal) {
        return {.status = refusal.status, .body = refusal.reason + "\n"};
    } catch (const std::exception& error) {
        return {.status = 500, .body = std::string(error.what()) + "\n"};
    }
}

}  // namespace rt
