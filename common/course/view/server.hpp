// An HTTP server on the loopback address, with a few concurrent connections.
#pragma once

#include "common/course/view/http.hpp"

#include <array>
#include <functional>
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
    void work(const Answer& answer) const;
    /// Refuses the requests of other web pages, also of one whose host name resolves to this
    /// machine.
    void check_host(const Request& request) const;
    [[nodiscard]] Response respond(const std::function<std::string()>& head,
                                   const Answer& answer) const;

    int listener_ = -1;
    std::array<int, 2> end_{-1, -1};  ///< a pipe whose second end is open until the server stops
    int port_ = 0;
    std::vector<std::thread> workers_;
};

}  // namespace rt
