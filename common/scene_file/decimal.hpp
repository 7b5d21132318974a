// A number as written in a scene: its value, and what rounding to double would hide.
#pragma once

#include <optional>
#include <string_view>

namespace rt {

/// Ranges are checked on the double in both precisions, so that both accept the same scenes:
/// "1.00000001" is more than 1 although the nearest float is 1.
struct Decimal {
    double value = 0;         ///< the nearest double; ± infinity if it is out of range
    bool zero = false;        ///< has no digit from 1 to 9; the value of a tiny number is 0 too
    bool whole = true;        ///< written without a point and without an exponent
    bool scientific = false;  ///< written with an exponent
};

/// Parses the whole text as a number: a sign, "12", "1.5", ".5" or "1.", an exponent. Returns
/// nothing for any other text, including hexadecimal, "inf" and "nan".
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view text);

}  // namespace rt
