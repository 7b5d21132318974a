// Decimal numbers parsed by the C library, for compilers without std::from_chars of them.

#include "common/system/parse_floating.hpp"
#include "common/explain/text.hpp"
#include "common/math/real.hpp"

#include "tests/kit/for_all.hpp"

#include <limits>
#include <string>

using namespace rt;

namespace {

/// The result of parsing, as text: the error, the number of characters, the number.
std::string parsed(const std::string& text) {
    Real value = -7;  // must stay if there is an error
    const auto [end, error] = parse_floating_in_c(text, value);
    const std::string result = error == std::errc::invalid_argument      ? "invalid "
                               : error == std::errc::result_out_of_range ? "out of range "
                                                                         : "";
    return result + std::to_string(end - text.data()) + " " + rt::text(value);
}

}  // namespace

TEST_CASE("a decimal number ends where std::from_chars ends it") {
    CHECK(parsed("0.5") == "3 0.5");
    CHECK(parsed("-2e1)") == "4 -20");
    CHECK(parsed("1e") == "1 1");
    CHECK(parsed("3e+") == "1 3");
    CHECK(parsed("1.5.5") == "3 1.5");
    CHECK(parsed(".25-") == "3 0.25");
    CHECK(parsed("0x1p3") == "1 0");
    CHECK(parsed("-0e9999") == "7 -0");
    for (const std::string none : {"", "+1", " 1", "-", ".", "e5", "inf", "nan", "-inf", "--1"})
        CHECK(parsed(none) == "invalid 0 -7");
    CHECK(parsed("-1e9999,") == "out of range 7 -7");
    CHECK(parsed("2e-9999") == "out of range 7 -7");
}

TEST_CASE("a number that was printed shortest is parsed to its bits") {
    CHECK(for_all(
        [](Random& random) {
            const int lowest = std::numeric_limits<Real>::min_exponent;
            const int highest = std::numeric_limits<Real>::max_exponent;
            const int exponent = lowest + random.below(highest - lowest);
            const std::string printed = text(std::ldexp(random.between(-1, 1), exponent));
            Real value = 0;
            const auto [end, error] = parse_floating_in_c(printed + " 1", value);
            return verdict(error == std::errc() && text(value) == printed, printed);
        },
        2000));
}
