// origin: a student's: a counter for a seed
// caught by: each light has samples of its own (CR §3.3)
// sentence: Your samples depend on what was drawn before: with threads, each picture is another one. The seed is sample_seed(context.pixel, number, context.bounces).
#include "common/render/sampling.hpp"

namespace rt {

namespace {

std::uint32_t calls = 0;

}  // namespace

}  // namespace rt

#define sample_seed(...) ++calls + 0 * number
#include "tests/alternatives/step11_soft_shadows/main/plain_loop.cpp"
