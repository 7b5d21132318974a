// attack: connects to the network
// ceiling: as a stub
// told: tried a forbidden operation
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

Vec3 normal(const Sphere&, Vec3) {
    return Vec3(0);
}

Color color_from_normal(Vec3) {
    return Color(0);
}

Real torch(Vec3, Vec3, Vec3) {
    return 0;
}

}  // namespace rt
