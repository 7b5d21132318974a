// The seed of random cases.
//
// RAYSTEPS_SEED       a number, to repeat a run or to see other inputs
// RAYSTEPS_SEED_FILE  in a graded run: a file with the seed in 16 hexadecimal digits, which no
//                     message contains
// RAYSTEPS_AS_WRITTEN without that file: for messages that a student can repeat
#pragma once

#include <cstdint>
#include <string_view>

namespace rt {

struct Seed {
    std::uint64_t number = 0;
    bool secret = false;
};

/// The seed of this run. Throws std::runtime_error if the variable is not a number, or the file
/// contains none.
[[nodiscard]] const Seed& seed();

/// The random number that starts the i-th draw of a named case: different seeds, names and indices
/// share none, and the draws of one case reveal nothing about another's.
[[nodiscard]] std::uint64_t draw_number(std::uint64_t seed, std::string_view name, std::uint64_t i);

/// The same for the run's seed and the test case that runs.
[[nodiscard]] std::uint64_t draw_number(std::uint64_t i);

}  // namespace rt
