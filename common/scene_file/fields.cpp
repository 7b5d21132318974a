#include "common/scene_file/fields.hpp"

#include "common/math/vector.hpp"
#include "common/system/escaping.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace rt {
inline namespace RT_PRECISION {

namespace {

/// Returns whether 0 ≤ number ≤ bound for the number as written; −0 is 0.
bool within(const Decimal& number, int bound) {
    const bool below = std::signbit(number.value) && exceeds(number, 0);
    return !below && !exceeds(number, bound);
}

bool positive(const Decimal& number) {
    return !std::signbit(number.value) && exceeds(number, 0);
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
    return up_to(1, take_word(field), field);
}

std::string Fields::word(std::string_view field) {
    return std::string(take_word(field).text);
}

Real Fields::ratio_option(std::string_view key, Real otherwise) {
    const auto token = option(key);
    return token ? up_to(1, *token, key) : otherwise;
}

Real Fields::length_option(std::string_view key, Real otherwise) {
    const auto token = option(key);
    return token ? length_of(*token, what(key)) : otherwise;
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
    return std::min(up_to(180, take_word(field), field) * pi / 180, largest);
}

Color Fields::color(std::string_view field) {
    skip_to_color(field);
    if (hexadecimal_follows()) return hexadecimal_color(field);
    if (word_for_color(field)) return Color(1);
    const Triple read = triple(field);
    const std::string name = component_of(what(field));
    for (std::size_t i = 0; i < read.parts.size(); ++i) {
        if (!within(read.numbers[i], 255)) refuse(read.parts[i], name + " must be from 0 to 255");
        if (read.numbers[i].whole) continue;
        doubt(read.parts[i], "whole color",
              name + " must be a whole number, not " + quoted(read.parts[i].text), "it is kept");
    }
    return read.value / Real(255);
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

int Fields::pixels(std::string_view field) {
    const Token token = take_word(field);
    const auto number = parse_decimal(token.text);
    if (!number || !number->whole || !positive(*number)) {
        refuse(token, what(field) + " must be a positive whole number");
    }
    if (!exceeds(*number, largest_side)) return static_cast<int>(number->value);
    warn(token, "resolution",
         what(field) + " is clipped from " + quoted(token.text) + " to " +
             std::to_string(largest_side));
    return largest_side;
}

Decimal Fields::decimal(Token token, const std::string& name) {
    const auto number = parse_decimal(token.text);
    if (!number) refuse(token, name + " must be a decimal number");
    if (std::isinf(Real(number->value)))
        refuse(token, name + " must be small enough to compute with");
    if (number->scientific) {
        doubt(token, "exponent", quoted(token.text) + " has an exponent: expected a plain decimal",
              "it is read");
    }
    return *number;
}

Fields::Triple Fields::triple(std::string_view field) {
    return triple_of(take_triple(field), field);
}

Fields::Triple Fields::triple_of(const std::array<Token, 3>& parts, std::string_view field) {
    Triple read{.parts = parts, .numbers = {}, .value = Vec3(0)};
    for (std::size_t i = 0; i < read.parts.size(); ++i) {
        read.numbers[i] = decimal(read.parts[i], component_of(what(field)));
    }
    for (int i = 0; i < 3; ++i) read.value[i] = Real(read.numbers[std::size_t(i)].value);
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
    const Decimal number = decimal(token, name);
    if (!positive(number)) refuse(token, name + " must be positive");
    const auto length = Real(number.value);
    const bool vanishes = length / 2 == 0;
    if (vanishes) refuse(token, name + " must be large enough to compute with");
    return length;
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

/// A number from 0 to the bound, inclusive.
Real Fields::up_to(int bound, Token token, std::string_view field) {
    const Decimal number = decimal(token, what(field));
    if (within(number, bound)) return Real(number.value);
    refuse(token, what(field) + " must be from 0 to " + std::to_string(bound));
}

}  // namespace RT_PRECISION
}  // namespace rt
