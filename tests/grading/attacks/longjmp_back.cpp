// attack: jumps back to its first answer, from the second
// ceiling: as a stub
// stubs: normal color_from_normal torch
#include <csetjmp>
#include "steps/step03_sphere/sphere.hpp"
namespace rt {
namespace {
jmp_buf first;
bool been = false;
}  // namespace
std::optional<Real> intersect(const Ray&, const Sphere&, Interval) {
    if (!been) {
        been = true;
        if (setjmp(first) == 0) return 1;
        return 2;
    }
    longjmp(first, 1);
}
}  // namespace rt
