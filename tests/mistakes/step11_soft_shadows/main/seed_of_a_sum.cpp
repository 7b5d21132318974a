// origin: a student's: a seed of row + column
// caught by: each light has samples of its own (CR §3.3)
// sentence: Pixels with the same row + column have the same samples, so that the noise has stripes: sample_seed(context.pixel, number, context.bounces) mixes all.
#include "common/render/sampling.hpp"

namespace rt {

namespace {

std::uint32_t sum_seed(Pixel pixel, std::uint32_t number) {
    return std::uint32_t(pixel.row + pixel.column) * 7919U + number * 104729U;
}

}  // namespace

}  // namespace rt

#define sample_seed(pixel, number, bounce) sum_seed(pixel, number)
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
