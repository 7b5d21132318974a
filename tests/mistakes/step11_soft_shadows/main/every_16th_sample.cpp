// origin: a student's: the index times 16
// caught by: a single sample is seen or not, and --shadow-samples is their number (CR §3.3)
// sentence: Samples are left out: trace spread_sample(i, seed) for each i from 0 to context.settings.shadow_samples − 1. If you stop once the first agree, or skip some, a light that is almost hidden, or almost free, loses its small share.
#include "common/render/sampling.hpp"

#define spread_sample(i, seed) spread_sample(16 * (i), seed)
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
