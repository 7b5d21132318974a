// attack: exits by quick_exit, past all destructors
// ceiling: as a stub
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace {

const bool done = [] {
    std::quick_exit(0);
    return true;
}();

}  // namespace
