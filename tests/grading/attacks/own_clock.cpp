// attack: replaces the clock, so that no time passes
// ceiling: as a stub
// compiles: no
// message: defines clock_gettime
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <ctime>

extern "C" int clock_gettime(clockid_t, timespec*) {
    return 0;
}
