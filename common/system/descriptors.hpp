// Descriptors that child processes do not inherit, and sockets whose client may disconnect, on
// every Unix. (pipe2, accept4, SOCK_CLOEXEC and MSG_NOSIGNAL are not on macOS.)
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <mutex>

namespace rt {

/// Held while a descriptor is created and marked, and while a child process is created: otherwise
/// the child of another thread could inherit the descriptor between the two.
inline std::mutex inheritance;

/// Marks a descriptor as not inherited, and returns it; -1 stays -1.
inline int keep_from_children(int descriptor) {
    if (descriptor != -1) fcntl(descriptor, F_SETFD, FD_CLOEXEC);
    return descriptor;
}

/// The end to read from and the end to write to; false if there are too many descriptors.
[[nodiscard]] inline bool make_pipe(std::array<int, 2>& ends) {
    const std::scoped_lock lock(inheritance);
    if (pipe(ends.data()) != 0) return false;
    for (const int end : ends) keep_from_children(end);
    return true;
}

/// The flag of send() with which a disconnected reader raises no SIGPIPE. Where there is none, the
/// socket has a property for it.
#ifdef MSG_NOSIGNAL
constexpr int send_without_signal = MSG_NOSIGNAL;
#else
constexpr int send_without_signal = 0;
#endif

/// A socket that is not inherited, and raises no SIGPIPE if it is sent to with send_without_signal.
inline int prepare_socket(int socket) {
#ifdef SO_NOSIGPIPE
    const int yes = 1;
    if (socket != -1) setsockopt(socket, SOL_SOCKET, SO_NOSIGPIPE, &yes, sizeof yes);
#endif
    return keep_from_children(socket);
}

}  // namespace rt
