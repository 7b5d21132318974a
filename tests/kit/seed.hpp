// What random cases are drawn from.
//
// RAYSTEPS_SEED       a number, to repeat a run or to see other questions
// RAYSTEPS_SEED_FILE  in a graded run: a file with the seed in 16 hexadecimal digits, which no
//                     message contains
#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

struct Seed {
    std::uint64_t number = 0;
    bool secret = false;
};

/// The run's. Throws std::runtime_error if the file has none.
[[nodiscard]] const Seed& seed();

/// The number that the i-th draw of a named case starts from: other seeds, names and places share
/// none, and from the draws of one case follows nothing about another.
[[nodiscard]] std::uint64_t draw_number(std::uint64_t seed, std::string_view name, std::uint64_t i);

/// The same for the run's seed and the test case that runs.
[[nodiscard]] std::uint64_t draw_number(std::uint64_t i);

}  // namespace rt
