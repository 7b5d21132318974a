// An HTTP server on the loopback address. One thread receives all requests, and the answers are
// made and sent by a few others, so that no connection without a whole request holds up another.
#pragma once

#include "common/course/view/http.hpp"

#include <array>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace rt {

class Server {
public:
    /// A handler is called by several threads at once. A Refusal that it throws is sent as the
    /// response.
    using Answer = std::function<Response(const Request&)>;

    /// Throws InputError if the port (0: any) is taken.
    explicit Server(int port);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] int port() const { return port_; }
    void start(const Answer& answer);
    /// Accepts no more requests, and returns after the current ones are answered.
    void stop();

private:
    /// A connection: what was received of its request, or why it is refused.
    struct Visitor;

    void receive();
    void accept_one(std::list<Visitor>& visitors) const;
    void queue_up(std::list<Visitor>& visitors, std::list<Visitor>::iterator visitor);
    void work(const Answer& answer);
    /// Refuses the requests of other web pages, also of one whose host name resolves to this
    /// machine.
    void check_host(const Request& request) const;
    [[nodiscard]] Response respond(const Visitor& visitor, const Answer& answer) const;

    int listener_ = -1;
    std::array<int, 2> end_{-1, -1};  ///< a pipe whose second end is open until the server stops
    int port_ = 0;
    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<Visitor> queue_;  ///< those with a whole request, and those that are refused
    bool over_ = false;
};

/// A page's server on this machine, until Ctrl-C.
class Host {
public:
    /// From now on, Ctrl-C ends `serve` and not the program. Throws InputError if the port (0: any)
    /// is taken.
    explicit Host(int port);

    /// Prints the address of the first page and answers requests until Ctrl-C; then calls `stop`,
    /// which must end the requests that are being answered. All addresses are below a secret one
    /// that only readers of the terminal know. The handler gets the rest of the path, without a
    /// slash at its start.
    void serve(const std::string& first_page, const Server::Answer& answer,
               const std::function<void()>& stop);

private:
    int heard_ = -1;  ///< readable after Ctrl-C
    Server server_;
};

}  // namespace rt
