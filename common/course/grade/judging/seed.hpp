// The secret seed of a graded run's random inputs, in the file seed.txt of the results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rt::grade {

/// "results/seed.txt": 16 hexadecimal digits, for the lecturer only.
[[nodiscard]] std::filesystem::path seed_file(const std::filesystem::path& results);

/// The seed in a file. Throws InputError if it contains none.
[[nodiscard]] std::uint64_t read_seed(const std::filesystem::path& file);

/// The seed of these results: the existing one; else that of the given file; else a new one, of 64
/// random bits from the system. It is stored once, so that runs that start at the same time use the
/// same seed. Throws InputError if the given file has no seed, or a different one.
[[nodiscard]] std::uint64_t agreed_seed(const std::filesystem::path& results,
                                        const std::optional<std::filesystem::path>& given);

/// Eight digits that identify the seed without revealing it.
[[nodiscard]] std::string seed_identifier(std::uint64_t seed);

}  // namespace rt::grade
