// A suite's sentence on a failure, as a student reads it on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

/// The text with at most this many digits of each number that has a point or an exponent.
[[nodiscard]] std::string with_digits(const std::string& text, int digits);

/// C++ of a call without what it does not show: fields with their default values, and digits of
/// numbers that are rounded. It is to be read: a line to paste is kept as it is.
[[nodiscard]] std::string brief_code(const std::string& code);

/// The lines of a failure. The call is brief. The numbers of the student's answer and of the
/// expected one have six digits, or more until the two answers differ. Unless `complete`, the lines
/// to paste and the seed are left out.
[[nodiscard]] std::vector<std::string> failure_lines(const std::string& failure, bool complete);

/// The text, or if it has more lines than `most`, its first ones, at least one, and the mark.
[[nodiscard]] std::string fitted(const std::string& text, std::size_t most,
                                 const std::string& mark);

/// True for the line of a failure that begins its answers: "  got: …" or "  expected: …".
[[nodiscard]] bool starts_answer(const std::string& line);

/// The number of characters of the call, which comes before what it answered.
[[nodiscard]] std::size_t length_of_call(const std::string& failure);

}  // namespace rt
