// Listens on this machine's own address, and answers a few at a time.
#pragma once

#include "common/course/view/http.hpp"

#include <functional>
#include <thread>
#include <vector>

namespace rt {

class Server {
public:
    /// Answers may be asked for by several threads at once; a Refusal is sent as one.
    using Answer = std::function<Response(const Request&)>;

    /// Throws InputError if the port (0: any) is taken.
    explicit Server(int port);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    [[nodiscard]] int port() const { return port_; }
    void start(const Answer& answer);
    /// Takes no more requests, and returns once those at hand are answered.
    void stop();

private:
    void work(const Answer& answer) const;
    /// Nobody else's page reaches us, not even one whose name leads to this machine.
    void check_host(const Request& request) const;
    [[nodiscard]] Response respond(const std::function<std::string()>& head,
                                   const Answer& answer) const;

    int listener_ = -1;
    int port_ = 0;
    std::vector<std::thread> workers_;
};

}  // namespace rt
