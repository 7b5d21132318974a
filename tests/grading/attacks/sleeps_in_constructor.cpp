// attack: sleeps before the first query
// ceiling: as a stub
// stubs: intersect normal color_from_normal torch
#include "steps/step03_sphere/sphere.hpp"

#include <unistd.h>

namespace {

const unsigned slept = sleep(1000);

}  // namespace
