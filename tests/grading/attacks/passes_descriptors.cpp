// attack: sends messages with descriptors over the channel
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <sys/socket.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    msghdr message{};
    sendmsg(3, &message, 0);
    return std::nullopt;
}

}  // namespace rt
