// origin: invented: break in place of continue
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: A light behind the surface ends your loop over the lights. Go on with the next light.
#include "tests/mistakes/step11_soft_shadows/light_behind.hpp"

#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
