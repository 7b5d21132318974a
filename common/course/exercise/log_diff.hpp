// Comparison of the student's explanation of a pixel with the reference's: of numbers, not of
// texts.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A line of one explanation or of both: the same quantity, with equal or different values.
struct LogRow {
    std::optional<std::string> mine;
    std::optional<std::string> reference;
    bool differs = false;
};

struct LogDiff {
    std::vector<LogRow> rows;  ///< at most the first 2000 lines of each explanation
    std::string first;         ///< "t, of Sphere{…}": the first difference; empty without one
    std::vector<std::string> unwritten;  ///< the messages about functions that are not written yet
    /// The student's `trace` logs no shape: it has a loop of its own, without ClosestHit. The
    /// reference's sections about shapes are left out.
    bool has_own_loop = false;
};

/// Two explanations, line by line. Numbers that differ by rounding alone are equal.
[[nodiscard]] LogDiff compare_logs(const std::string& mine, const std::string& reference);

/// True for the first line of a section.
[[nodiscard]] bool is_heading(const LogRow& row);

}  // namespace rt
