// origin: a student's: i * lights + number
// caught by: each light has samples of its own (CR §3.3)
// sentence: Your lights divide one sequence: with two lights, each has every second point, and these cover half of it only. Each light has a seed of its own, and spread_sample(i, seed) for each i from 0.
#include "common/render/sampling.hpp"

#define spread_sample(i, seed) spread_sample((i)*std::uint32_t(scene.lights.size()) + number, seed)
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
