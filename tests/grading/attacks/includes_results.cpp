// attack: shows the results of others in the compiler's errors
// ceiling: as a stub
// compiles: no
// message: results
// message without: points
// stubs: intersect normal color_from_normal torch
#include "@RESULTS@"
#include "steps/step03_sphere/sphere.hpp"
