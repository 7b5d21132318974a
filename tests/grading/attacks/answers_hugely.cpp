// attack: answers with 200 MB, by the ticket that it finds in its memory
// ceiling: as a stub
// message: gave an answer that is larger than any answer is
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

#include <vector>

namespace rt {

namespace {

/// Above its own on the stack there is a frame: the size of the question, and its ticket.
unsigned long find_ticket() {
    constexpr unsigned long size_of_question = 2 + 6 * 8 + 4 * 8 + 2 * 8;
    const auto* word = static_cast<const volatile unsigned long*>(__builtin_frame_address(0));
    while (*word != size_of_question || word[1] < 65536) ++word;
    return word[1];
}

}  // namespace

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    const unsigned long head[]{200000000, find_ticket()};
    std::vector<char> much(200000000);
    if (write(3, head, sizeof head) < 0) return 1;
    for (std::size_t at = 0; at < much.size();) {
        const ssize_t count = write(3, much.data() + at, much.size() - at);
        if (count < 0) return 1;
        at += std::size_t(count);
    }
    return std::nullopt;
}

}  // namespace rt
