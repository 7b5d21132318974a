// attack: includes the reference from where its header is
// ceiling: as a stub
// compiles: no
// message: reference/sphere.cpp
#include "steps/step03_sphere/sphere.hpp"

#include "steps/step03_sphere/../step03_sphere/reference/sphere.cpp"
