// Values and errors as text.

#include "common/explain/text.hpp"
#include "common/scene/scene.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parse_floating.hpp"

#include "tests/kit/for_all.hpp"

#include <cmath>
#include <limits>
#include <string>

using namespace rt;

namespace {

/// Any finite number: every exponent is as likely as any other.
Real any_number(Random& random) {
    constexpr int lowest = std::numeric_limits<Real>::min_exponent;
    constexpr int highest = std::numeric_limits<Real>::max_exponent;
    const int exponent = lowest + random.below(highest - lowest);
    return std::ldexp(random.between(-1, 1), exponent);
}

/// The number that a text is, digits to bits, by the standard library.
Real number(std::string written) {
    if (written.starts_with("Real(")) written = written.substr(5, written.size() - 6);
    Real value = 0;
    const auto read = parse_floating(written, value);
    return read.ec == std::errc() && read.ptr == written.data() + written.size() ? value : NAN;
}

bool same(Real a, Real b) {
    return a == b && std::signbit(a) == std::signbit(b);
}

}  // namespace

TEST_CASE("text() is the shortest that reads back as the same number") {
    CHECK(text(Real(0.1)) == "0.1");
    CHECK(text(Real(-2)) == "-2");
    CHECK(text(Real(1) / 4) == "0.25");
    CHECK(text(Vec2(1, Real(0.5))) == "(1, 0.5)");
    CHECK(text(Vec3(0, -1, infinity)) == "(0, -1, inf)");
    CHECK(for_all(
        [](Random& random) {
            const Real value = any_number(random);
            return verdict(same(number(text(value)), value), text(value));
        },
        10000));
}

TEST_CASE("code() makes the same number again") {
    CHECK(code(Real(3)) == "3");
    CHECK(code(Real(0.5)) == "Real(0.5)");
    CHECK(code(infinity) == "infinity");
    CHECK(code(-infinity) == "-infinity");
    CHECK(code(Real(NAN)) == "NAN");
    CHECK(text(Real(NAN)) == "NaN");
    CHECK(code(Real(-0.0)) == "Real(-0.0)");
    CHECK(code(std::ldexp(Real(1), 40)) == "Real(1099511627776.0)");  // too large for an int
    CHECK(for_all(
        [](Random& random) {
            const Real value = any_number(random);
            return verdict(same(number(code(value)), value), code(value));
        },
        10000));
}

TEST_CASE("code() of a value is C++ that makes it") {
    // Left: the text to paste, letter by letter.
    CHECK(code(Ray{.origin = {0, 0, 5}, .direction = {Real(0.5), 0, -1}}) ==
          "Ray{.origin = {0, 0, 5}, .direction = {Real(0.5), 0, -1}}");
    CHECK(code(Interval{.min = 0, .max = infinity}) == "Interval{.min = 0, .max = infinity}");
    CHECK(code(Basis{.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}}) ==
          "Basis{.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}}");
    CHECK(code(Sphere{.center = {0, 0, -5}, .radius = Real(0.5)}) ==
          "Sphere{.center = {0, 0, -5}, .radius = Real(0.5)}");
    CHECK(code(Plane{.point = {0, -1, 0}, .normal = {0, 2, 0}}) ==
          "Plane{.point = {0, -1, 0}, .normal = {0, 2, 0}}");
    CHECK(code(Triangle{.a = {0, 0, 0}, .b = {1, 0, 0}, .c = {0, 1, 0}}) ==
          "Triangle{.a = {0, 0, 0}, .b = {1, 0, 0}, .c = {0, 1, 0}}");
    CHECK(code(Square{.center = {1, 2, 3},
                      .basis = Basis{.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}},
                      .side = 2,
                      .one_sided = true}) ==
          "Square{.center = {1, 2, 3}, "
          ".basis = Basis{.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}}, "
          ".side = 2, .one_sided = true}");
    CHECK(code(Cylinder{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2}) ==
          "Cylinder{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2}");
    CHECK(code(Cone{.apex = {0, 2, 0}, .axis = {0, -1, 0}, .radius = 1, .height = 2}) ==
          "Cone{.apex = {0, 2, 0}, .axis = {0, -1, 0}, .radius = 1, .height = 2}");
}

TEST_CASE("an error is one plain line, whatever the names in it") {
    const InputError error({"a\nb\033[31m.rt", 3, 7}, "not \"\t\x7f\", été");
    CHECK(error.what() == std::string("a?b?[31m.rt:3:7: error: not \"??\", été"));
    CHECK(InputError({}, "alone").what() == std::string("error: alone"));
}
