// attack: connects to the network
// ceiling: as a stub
// message: tried a forbidden operation
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const int line = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in home{};
    home.sin_family = AF_INET;
    if (connect(line, reinterpret_cast<sockaddr*>(&home), sizeof home) == 0) return 1;
    return std::nullopt;
}

}  // namespace rt
