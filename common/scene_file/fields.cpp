#include "common/scene_file/fields.hpp"

#include "common/math/vector.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

namespace {

/// Returns whether the number as written is below 0; −0 is not.
bool negative(const Decimal& number) {
    return std::signbit(number.value) && exceeds(number, 0);
}

/// Returns whether 0 ≤ number ≤ bound for the number as written; −0 is 0.
bool within(const Decimal& number, int bound) {
    return !negative(number) && !exceeds(number, bound);
}

std::string component_of(const std::string& name) {
    return "each component of " + name;
}

}  // namespace

Vec3 Fields::point(std::string_view field) {
    return to_our_axes(triple(field).value, axes_);
}

Vec3 Fields::direction(std::string_view field) {
    return to_our_axes(direction_of(triple(field), field), axes_);
}

Vec3 Fields::camera_direction(std::string_view field) {
    return to_our_axes(unit_direction(triple(field), field).value_or(Vec3(0)), axes_);
}

Real Fields::length(std::string_view field) {
    return length_of(take_word(field), what(field));
}

Vec3 Fields::lengths(std::string_view field) {
    const auto parts = take_triple(field);
    const std::string name = component_of(what(field));
    return {length_of(parts[0], name), length_of(parts[1], name), length_of(parts[2], name)};
}

Real Fields::ratio(std::string_view field) {
    return up_to(1, take_word(field), what(field));
}

std::string Fields::file(std::string_view field) {
    const Token first = take_word(field);
    const std::optional<Token> last = last_word_before_triple();
    if (last) refuse(joined(first, *last), what(field) + " must have a name without blanks");
    return std::string(first.text);
}

bool Fields::is_other_layout(std::string_view number) {
    if (strict() || triples_follow() < 2) return false;
    const Token token = take_word(number);
    doubt(token, "other layout " + what(number),
          what(number) + " must be a decimal number, not " + quoted(token.text),
          "the line is ignored");
    skip_rest();
    return true;
}

Real Fields::ratio_option(std::string_view key, Real otherwise) {
    const auto token = option(key);
    return token ? up_to(1, *token, what(key)) : otherwise;
}

Real Fields::length_option(std::string_view key, Real otherwise) {
    const auto token = option(key);
    if (!token) return otherwise;
    return positive_length(*token, what(key), "it is ignored").value_or(otherwise);
}

Vec3 Fields::direction_option(std::string_view key, Vec3 otherwise) {
    const auto parts = option_triple(key);
    return parts ? direction_of(triple_of(*parts, key), key) : otherwise;
}

Real Fields::angle(std::string_view field) {
    if (at_end()) {
        doubt(end_of_line(), "no angle", missing(field), "it is 60");
        return pi / 3;
    }
    // π rounded to float is greater than π, and the tangent of its half is negative.
    const Real largest = std::nextafter(pi, Real(0));
    return std::min(up_to(180, take_word(field), what(field)) * pi / 180, largest);
}

Color Fields::color(std::string_view field) {
    skip_to_color(field);
    if (hexadecimal_follows()) return hexadecimal_color(field);
    if (word_for_color(field)) return Color(1);
    const std::array<Token, 3> parts = take_triple(field);
    const std::string name = component_of(what(field));
    Color color(0);
    for (int i = 0; i < 3; ++i) {
        const Token part = parts[std::size_t(i)];
        const Decimal number = decimal(part, name);
        color[i] = up_to(255, number, part, name) / 255;
        if (number.whole || !(number.value <= 255)) continue;
        doubt(part, "whole color", name + " must be a whole number, not " + quoted(part.text),
              "it is kept");
    }
    return color;
}

/// Consumes a word `#rrggbb` or `#rgb`. Strict reading refuses it.
Color Fields::hexadecimal_color(std::string_view field) {
    const Token word = take_word(field);
    const std::string_view digits = word.text.substr(1);
    const std::size_t each = digits.size() / 3;
    Color color(0);
    std::string decimal;
    for (int i = 0; i < 3; ++i) {
        int value = 0;
        const char* const first = digits.data() + each * std::size_t(i);
        std::from_chars(first, first + each, value, 16);
        if (each == 1) value *= 17;  // #f80 is #ff8800
        color[i] = Real(value) / 255;
        decimal.append(i == 0 ? "" : ",").append(std::to_string(value));
    }
    doubt(word, "hexadecimal color",
          what(field) + " must be three numbers as in 1,2,3, not " + quoted(word.text),
          "it is " + decimal);
    return color;
}

/// Consumes words up to the first that is not a number, if lenient reading finds such a word and no
/// triple.
bool Fields::word_for_color(std::string_view field) {
    if (strict() || !words_without_triple()) return false;
    for (std::optional<Decimal> number = Decimal(); number;) {
        const Token word = take_word(field);
        number = parse_decimal(word.text);
        doubt(word, "word for color " + what(""),
              quoted(word.text) + " is in place of " + what(field), "it is white");
    }
    return true;
}

Color Fields::color_or_white() {
    if (!at_end() || hexadecimal_follows()) return color();
    doubt(end_of_line(), "no color", missing("color"), "it is white");
    return Color(1);
}

std::optional<int> Fields::pixels(std::string_view field) {
    const auto ignore_line = [this](Token token, const std::string& why) {
        doubt(token, "no resolution", why, "the line is ignored");
        return std::nullopt;
    };
    if (at_end()) return ignore_line(end_of_line(), missing(field));
    const Token token = take_word(field);
    const auto number = parse_decimal(token.text);
    const std::string rule = what(field) + " must be a positive whole number";
    if (!number || negative(*number)) refuse(token, rule);
    const std::string not_this = rule + ", not " + quoted(token.text);
    if (!exceeds(*number, 0)) return ignore_line(token, not_this);
    const int nearest = exceeds(*number, largest_side)
                            ? largest_side
                            : std::max(1, static_cast<int>(std::lround(number->value)));
    if (!number->whole)
        doubt(token, "whole resolution", not_this, "it is " + std::to_string(nearest));
    if (!exceeds(*number, largest_side)) return nearest;
    warn(token, "resolution",
         what(field) + " is clipped from " + quoted(token.text) + " to " +
             std::to_string(largest_side));
    return largest_side;
}

Decimal Fields::decimal(Token token, const std::string& name) {
    const auto number = parse_decimal(token.text);
    if (!number) refuse(token, name + " must be a decimal number");
    if (number->scientific) {
        doubt(token, "exponent", quoted(token.text) + " has an exponent: expected a plain decimal",
              "it is read");
    }
    return *number;
}

Real Fields::real(const Decimal& number, Token token, const std::string& name) const {
    if (std::isinf(Real(number.value)))
        refuse(token, name + " must be small enough to compute with");
    return Real(number.value);
}

Fields::Triple Fields::triple(std::string_view field) {
    return triple_of(take_triple(field), field);
}

Fields::Triple Fields::triple_of(const std::array<Token, 3>& parts, std::string_view field) {
    Triple read{.parts = parts, .numbers = {}, .value = Vec3(0)};
    const std::string name = component_of(what(field));
    for (std::size_t i = 0; i < read.parts.size(); ++i) {
        read.numbers[i] = decimal(read.parts[i], name);
        read.value[int(i)] = real(read.numbers[i], read.parts[i], name);
    }
    return read;
}

Vec3 Fields::direction_of(const Triple& read, std::string_view field) {
    const auto found = unit_direction(read, field);
    if (found) return *found;
    const Token all = joined(read.parts[0], read.parts[2]);
    const std::string expected = "expected a direction such as 0,1,0";
    if (strict()) refuse(all, what(field) + " must not be zero: " + expected);
    warn(all, "zero " + what(field),
         what(field) + " is zero: " + expected + "; the shape is left out");
    left_out_ = true;
    return {0, 0, 1};
}

Real Fields::length_of(Token token, const std::string& name) {
    const auto length = positive_length(token, name, "the shape is left out");
    if (!length) left_out_ = true;
    return length.value_or(1);
}

/// A length whose half is positive. One that is zero, or lost by rounding, is nothing; strict
/// reading refuses it.
std::optional<Real> Fields::positive_length(Token token, const std::string& name,
                                            const std::string& remedy) {
    const Decimal number = decimal(token, name);
    if (negative(number)) refuse(token, name + " must be positive");
    const Real length = real(number, token, name);
    if (length / 2 > 0) return length;
    const char* const rule =
        exceeds(number, 0) ? " must be large enough to compute with" : " must be positive";
    doubt(token, "no " + name, name + rule + ", not " + quoted(token.text), remedy);
    return std::nullopt;
}

/// A unit direction, or nothing if it is zero. Strict reading requires components from −1 to 1, as
/// the format does; lenient reading accepts any length.
std::optional<Vec3> Fields::unit_direction(const Triple& read, std::string_view field) {
    for (std::size_t i = 0; strict() && i < read.parts.size(); ++i) {
        if (!exceeds(read.numbers[i], 1)) continue;
        refuse(read.parts[i], component_of(what(field)) + " must be from -1 to 1");
    }
    if (read.value == Vec3(0)) return std::nullopt;
    return unit(read.value);
}

Real Fields::up_to(int bound, Token token, const std::string& name) {
    return up_to(bound, decimal(token, name), token, name);
}

/// A number from 0 to the bound, inclusive. Strict reading refuses any other.
Real Fields::up_to(int bound, const Decimal& number, Token token, const std::string& name) {
    if (within(number, bound)) return Real(number.value);
    const int nearest = negative(number) ? 0 : bound;
    doubt(token, "range of " + name,
          name + " must be from 0 to " + std::to_string(bound) + ", not " + quoted(token.text),
          "it is " + std::to_string(nearest));
    return Real(nearest);
}

}  // namespace RT_PRECISION
}  // namespace rt
