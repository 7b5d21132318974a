// attack: answers with ten thousand frames before the first query
// ceiling: as a stub
// told: wrote into the channel
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

struct Frame {
    unsigned long size;
    unsigned long ticket;
};

namespace {

const bool done = [] {
    for (unsigned long ticket = 0; ticket < 10000; ++ticket) {
        const Frame frame{.size = 1, .ticket = ticket};
        if (write(3, &frame, sizeof frame) < 0) break;
        if (write(3, "", 1) < 0) break;
    }
    return true;
}();

}  // namespace

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
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
