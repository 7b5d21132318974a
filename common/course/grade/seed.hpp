// What the questions of a graded run are drawn from: a secret, in the file seed.txt of the results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rt::grade {

/// "results/seed.txt": 16 hexadecimal digits, for the lecturer's eyes only.
[[nodiscard]] std::filesystem::path seed_file(const std::filesystem::path& results);

/// The seed of a file. Throws InputError if it has none.
[[nodiscard]] std::uint64_t read_seed(const std::filesystem::path& file);

/// The seed of these results: the one that they have; else that of the file given; else a new one,
/// of 64 bits of the system's. It is stored there, once: runs that start at the same time agree.
/// Throws InputError if the file given has no seed, or another one.
[[nodiscard]] std::uint64_t agreed_seed(const std::filesystem::path& results,
                                        const std::optional<std::filesystem::path>& given);

/// Eight digits by which to know the seed again, and from which it does not follow.
[[nodiscard]] std::string seed_identifier(std::uint64_t seed);

}  // namespace rt::grade
