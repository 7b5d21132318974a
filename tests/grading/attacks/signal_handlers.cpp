// attack: ignores every signal
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <csetjmp>
#include <csignal>

namespace {

sigjmp_buf again;

void go_on(int) {
    siglongjmp(again, 1);
}

}  // namespace

namespace rt {

std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    for (int each = 1; each < NSIG; ++each) std::signal(each, go_on);
    sigsetjmp(again, 1);
    for (volatile int* nowhere = nullptr;;) *nowhere = 1;
}

}  // namespace rt
