// attack: gives the ticket back, promises 4 MB, and sends a byte a second
// ceiling: as a stub
// told: no answer within 1 s
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>
#include <thread>

struct Frame {
    unsigned long size;
    unsigned long ticket;
};

namespace {

const bool done = [] {
    std::thread([] {
        Frame frame{};
        if (read(3, &frame, sizeof frame) != sizeof frame) return;
        frame.size = 4000000;
        if (write(3, &frame, sizeof frame) < 0) return;
        while (write(3, "", 1) == 1) sleep(1);
    }).detach();
    sleep(3);  // delays main
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
