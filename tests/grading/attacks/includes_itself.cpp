// attack: includes itself twice, without end
// ceiling: as a stub
// compiles: no
// stubs: intersect normal color_from_normal torch
#include __FILE__
#include __FILE__
#include "steps/step03_sphere/sphere.hpp"
