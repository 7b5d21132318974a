// A number as a scene writes it: its value, and what the rounding to Real would hide.
#pragma once

#include "common/real.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rt::inline RT_PRECISION {

/// ± 0.d₁d₂d₃… × 10^point. Ranges are judged on the digits, so that both precisions accept the same
/// scenes: "1.00000001" is more than 1 although the nearest float is 1.
struct Decimal {
    Real value = 0;           ///< the nearest Real; ± infinity if it is out of range
    bool negative = false;    ///< whether it has a minus sign, be it −0
    bool whole = true;        ///< written without a point and without an exponent
    bool scientific = false;  ///< written with an exponent
    std::string digits;       ///< neither first nor last is '0'; none for zero
    std::int64_t point = 0;
};

/// The number that all of the text spells: a sign, "12", "1.5", ".5" or "1.", an exponent. Nothing
/// for anything else, hexadecimal, "inf" and "nan" included.
[[nodiscard]] std::optional<Decimal> parse_decimal(std::string_view text);

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// Whether the magnitude of the number, as written, is greater than the bound, 0 or more.
[[nodiscard]] bool exceeds(const Decimal& number, int bound);

}  // namespace rt
