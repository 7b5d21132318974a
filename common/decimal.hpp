// A number as written in a scene: its value, and the digits that rounding to Real would hide.
#pragma once

#include "common/real.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt::inline RT_PRECISION {

/// ± 0.d₁d₂d₃… × 10^point. Ranges are checked on the decimal digits, so that both precisions accept
/// the same scenes: "1.00000001" is more than 1 although the nearest float is 1.
struct Decimal {
    Real value = 0;           ///< the nearest Real; ± infinity if it is out of range
    bool negative = false;    ///< has a minus sign, −0 included
    bool whole = true;        ///< written without a point and without an exponent
    bool scientific = false;  ///< written with an exponent
    std::string digits;       ///< neither the first nor the last is '0'; empty for zero
    std::int64_t point = 0;
};

/// Parses the whole text as a number: a sign, "12", "1.5", ".5" or "1.", an exponent. Returns
/// nothing for any other text, including hexadecimal, "inf" and "nan".
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view text);

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// Returns whether the magnitude of the number, as written, is greater than the bound, which is 0
/// or more.
[[nodiscard]] bool exceeds(const Decimal& number, int bound);

}  // namespace rt
