// The changes of marks by later runs, for the lecturer who answers for them.
#pragma once

#include "common/course/grade/results/results.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

/// The date; from SOURCE_DATE_EPOCH (reproducible builds) if two runs must have equal bytes.
[[nodiscard]] std::string today();

/// Appends a line to results/changes.csv if the points differ: the date, the student, the stage,
/// the points before and after, and the reason. Other runs may append at the same time. Throws
/// InputError.
void record_change(const std::filesystem::path& results, const Mark& before, const Mark& after);

/// The number of bytes of that file; 0 without it.
[[nodiscard]] std::uintmax_t size_of_changes(const std::filesystem::path& results);

/// Its lines from that byte on.
[[nodiscard]] std::vector<std::string> changes_since(const std::filesystem::path& results,
                                                     std::uintmax_t size);

}  // namespace rt::grade
