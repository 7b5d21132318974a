// origin: a student's: a seed of row ^ column
// caught by: each light has samples of its own (CR §3.3)
// sentence: A pixel has the samples of the one with its row and column exchanged, so that the noise has a pattern: sample_seed(context.pixel, number, context.bounces) mixes all.
#include "common/render/sampling.hpp"

#define sample_seed(pixel, number, bounce) \
    std::uint32_t(pixel.row ^ pixel.column) * 7919U + number * 104729U
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
