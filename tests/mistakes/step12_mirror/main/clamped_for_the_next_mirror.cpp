// origin: a student's: trace returns no more than white
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: You limit a mirror's color to 1. What another mirror shows of it may be brighter than white.
#include "steps/step12_mirror/mirror.hpp"

#define mixed(...) min(mixed(__VA_ARGS__), Color(1))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
