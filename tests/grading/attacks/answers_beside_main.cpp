// attack: a thread reads the queries, and returns each ticket with an answer of its own
// ceiling: as a stub
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
        char question[4096];
        while (read(3, &frame, sizeof frame) == sizeof frame) {
            if (read(3, question, frame.size) < 0) break;
            frame.size = 2;  // answered, and nothing is hit
            if (write(3, &frame, sizeof frame) < 0 || write(3, "\0\0", 2) < 0) break;
        }
    }).detach();
    return true;
}();

}  // namespace
