// attack: exits from .preinit_array
// ceiling: as a stub
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <cstdlib>

namespace {

[[gnu::used, gnu::section(".preinit_array")]] void (*const first)() = [] { std::_Exit(0); };

}  // namespace
