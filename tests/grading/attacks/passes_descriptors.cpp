// attack: sends messages with descriptors over the channel
// ceiling: as a stub
// told: tried a forbidden operation
#include "steps/step03_sphere/sphere.hpp"

#include <sys/socket.h>

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    msghdr message{};
    sendmsg(3, &message, 0);
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
