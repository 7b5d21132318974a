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
    bool may_differ = false;  ///< two values, and both may be right
};

struct LogDiff {
    std::vector<LogRow> rows;   ///< at most the first 2000 lines of each explanation
    std::string first;          ///< "t, of Sphere{…}": the first difference; empty without one
    std::size_t first_row = 0;  ///< of that difference, if there is one
    std::vector<std::string> unwritten;  ///< the messages about functions that are not written yet
    /// The student's `trace` logs no shape: it has a loop of its own, without ClosestHit. The
    /// reference's sections about shapes are left out.
    bool has_own_loop = false;
    /// The hits of a student's own loop whose calls are logged, the closest first: "t = 4:
    /// Sphere{…}".
    std::vector<std::string> hits_of_loop = {};
};

/// The code that logs the tests of shapes in the student's explanation: ClosestHit, or the calls of
/// `intersect` in the student's own loop.
enum class Writer { queries, own_loop };

/// Two explanations, line by line. Numbers that differ by rounding alone are equal. The interval of
/// a test is no difference, nor is, with another interval, a hit that is not nearer, nor where a
/// shadow ray ends before its light, if that is close to it. A loop of the student's logs no
/// closest hit, and a shape that it leaves out is a difference.
[[nodiscard]] LogDiff compare_logs(const std::string& mine, const std::string& reference,
                                   Writer writer = Writer::queries);

/// The value of the last line "name = value", or an empty text.
[[nodiscard]] std::string value_in_log(const std::string& log, const std::string& name);

/// True for the first line of a section.
[[nodiscard]] bool is_heading(const LogRow& row);

// The comparison of two explanations as text for the terminal.

/// The first difference, and its section; then the other sections in which something differs.
/// Common lines are there once, different lines beneath one another. With a command that prints
/// all, it is at most 24 lines of the terminal, and ends with that command if lines are left out.
[[nodiscard]] std::string text(const LogDiff& diff, const std::string& all = "");

}  // namespace rt
