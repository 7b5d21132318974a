// origin: a student's: the parameters exchanged
// caught by: each light has samples of its own (CR §3.3)
// sentence: You exchange the index and the seed: your samples are independent, and the noise is three times as large. Sample number i is spread_sample(i, seed).
#include "common/render/sampling.hpp"

#define spread_sample(i, seed) spread_sample(seed, i)
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
