// attack: exits with status 0 before the first query
// ceiling: as a stub
// message: ended the program, with status 0
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace {

const bool done = [] {
    std::_Exit(0);
    return true;
}();

}  // namespace
