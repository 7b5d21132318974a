// attack: answers with ten thousand frames before the first query
// ceiling: as a stub
// message: wrote into the channel
// stubs: intersect normal color_from_normal torch
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
