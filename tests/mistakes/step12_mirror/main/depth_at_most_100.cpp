// origin: invented
// caught by: the option --depth is the largest number of reflections (CR §5.1)
// sentence: You allow a fixed number of reflections at most, whatever --depth is.
#include "steps/step12_mirror/mirror.hpp"

#define worth_reflecting(bounces, depth, weight) \
    (bounces < 100 && worth_reflecting(bounces, depth, weight))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
