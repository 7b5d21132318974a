// A page's server on this machine, until Ctrl-C.
#pragma once

#include "common/course/view/server.hpp"

#include <functional>
#include <string>

namespace rt {

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
