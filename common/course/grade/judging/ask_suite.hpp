// A program of the project that queries an untrusted worker, and the stage's suite as one.
#pragma once

#include "common/course/grade/judging/workshop.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/system/files.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace rt::grade {

/// The settings for grading a class.
struct Grading {
    fs::path project;
    fs::path build;
    fs::path results;
    BuildDirectory workshop;
    std::string seed;  ///< its identifier
    std::set<int> stages;
    /// The limit by the clock of a program that queries a worker. A precaution: the program itself
    /// ends a worker much earlier, by the time that it computes or sleeps.
    std::chrono::milliseconds longest_asking = std::chrono::minutes(15);
};

/// Runs one of the project's programs with an untrusted worker, which the launcher seals. The
/// program gets these variables, and none of the lecturer's environment that could change its
/// result. Throws Interrupted, or ProgramError if it has not ended after the longest time and has
/// computed little of it: the machine is at fault, and not the worker.
[[nodiscard]] ProcessResult run_asking(const Grading& grading, int stage, const Command& program,
                                       const Command& variables);

/// The report of a file's suite on the worker, run with these additional variables. Contains the
/// cases that were reached.
[[nodiscard]] std::vector<CaseMark> ask_suite(const Grading& grading, GradedFile graded,
                                              const fs::path& worker,
                                              const Command& more_variables = {});

// The secret seed of a graded run's random inputs, in the file seed.txt of the results.

/// "results/seed.txt": 16 hexadecimal digits, for the lecturer only.
[[nodiscard]] fs::path seed_file(const fs::path& results);

/// The seed in a file. Throws InputError if it contains none.
[[nodiscard]] std::uint64_t read_seed(const fs::path& file);

/// The seed of these results: the existing one; else that of the given file; else a new one, of 64
/// random bits from the system. It is stored once, so that runs that start at the same time use the
/// same seed. Throws InputError if the given file has no seed, or a different one.
[[nodiscard]] std::uint64_t agreed_seed(const fs::path& results,
                                        const std::optional<fs::path>& given);

/// Eight digits that identify the seed without revealing it.
[[nodiscard]] std::string seed_identifier(std::uint64_t seed);

}  // namespace rt::grade
