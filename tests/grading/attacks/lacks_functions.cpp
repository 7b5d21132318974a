// attack: brings nothing at all
// ceiling: as a stub
// compiles: no
// told: intersect
#include "steps/step03_sphere/sphere.hpp"
