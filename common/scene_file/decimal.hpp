// A number as written in a scene: its value, and what rounding to double would hide.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rt {

struct Decimal {
    double value = 0;         ///< the nearest double; ± infinity if it is out of range
    bool whole = true;        ///< written without a point and without an exponent
    bool scientific = false;  ///< written with an exponent
    std::string digits;       ///< neither the first nor the last is '0'; empty for zero
};

/// Parses the whole text as a number: a sign, "12", "1.5", ".5" or "1.", an exponent. Returns
/// nothing for any other text, including hexadecimal, "inf" and "nan".
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view text);

/// Returns whether the magnitude of the number, as written, is greater than the bound, which is 0
/// or more. Both precisions accept the same scenes by it: the nearest float of "1.00000001" is 1,
/// and so is the nearest double of 1 + 10⁻¹⁰⁰.
[[nodiscard]] bool exceeds(const Decimal& number, int bound);

}  // namespace rt
