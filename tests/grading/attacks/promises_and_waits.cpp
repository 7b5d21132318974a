// attack: gives the ticket back, promises 4 MB, and sends a byte a second
// ceiling: as a stub
// message: no answer within 0.5 s
// stubs: intersect normal color_from_normal torch
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
