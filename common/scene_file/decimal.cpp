#include "common/scene_file/decimal.hpp"

#include "common/system/parse_floating.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace rt {

namespace {

constexpr std::string_view digits = "0123456789";

/// Removes such characters from the start of the text, and returns their number.
std::size_t take(std::string_view& text, std::string_view characters,
                 std::size_t most = std::string_view::npos) {
    const std::size_t count = std::min({text.find_first_not_of(characters), text.size(), most});
    text.remove_prefix(count);
    return count;
}

/// Returns the digits of a number without the zeros at either end, and without a point.
std::string significant(std::string_view number) {
    std::string kept(number);
    std::erase(kept, '.');
    kept.erase(kept.find_last_not_of('0') + 1);
    kept.erase(0, kept.find_first_not_of('0'));
    return kept;
}

/// Returns the double nearest to an unsigned number; infinity if it is too large.
double nearest_double(std::string_view text) {
    double value = 0;
    if (parse_floating(text, value).ec == std::errc())
        return value;  // otherwise it does not report whether too large or too small
    // strtod returns the same in the "C" locale, which a program has until it selects another.
    return std::strtod(std::string(text).c_str(), nullptr);
}

}  // namespace

std::optional<Decimal> parse_decimal(std::string_view text) {
    const bool negative = text.starts_with('-');
    take(text, "+-", 1);
    const std::string_view magnitude = text;

    std::size_t count = take(text, digits);
    const bool has_point = take(text, ".", 1) == 1;
    if (has_point) count += take(text, digits);
    if (count == 0) return std::nullopt;
    const std::string_view mantissa = magnitude.substr(0, magnitude.size() - text.size());
    const bool scientific = take(text, "eE", 1) == 1;
    if (scientific) take(text, "+-", 1);
    if (scientific && take(text, digits) == 0) return std::nullopt;
    if (!text.empty()) return std::nullopt;

    const double value = nearest_double(magnitude);
    return Decimal{.value = negative ? -value : value,
                   .whole = !has_point && !scientific,
                   .scientific = scientific,
                   .digits = significant(mantissa)};
}

bool exceeds(const Decimal& number, int bound) {
    const double magnitude = std::abs(number.value);
    if (magnitude != bound) return magnitude > bound;
    // The nearest double is the bound. A number above it starts with its digits: 1.000…01. One
    // below it does not: 0.999….
    const std::string limit = significant(std::to_string(bound));
    return number.digits.starts_with(limit) && number.digits != limit;
}

}  // namespace rt
