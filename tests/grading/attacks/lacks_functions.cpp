// attack: brings nothing at all
// ceiling: as a stub
// compiles: no
// message: intersect
#include "steps/step03_sphere/sphere.hpp"
