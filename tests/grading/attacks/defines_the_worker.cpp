// attack: defines functions of the worker
// ceiling: as a stub
// compiles: no
// message: say_todo
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

namespace rt {

void say_todo(const char*, int, const char*) {}

}  // namespace rt
