// attack: prints a report of its own at the end
// ceiling: as a stub
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdio>

struct AtTheEnd {
    ~AtTheEnd() { std::puts("<testsuite errors=\"0\" failures=\"0\"/>"); }
} at_the_end;
