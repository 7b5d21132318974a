#include "common/course/exercise/failure_text.hpp"

#include "common/system/text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace rt {

namespace {

constexpr int call_digits = 7;
constexpr int least_digits = 6;
constexpr int most_digits = 17;

/// Removes a field with this value wherever it follows another one.
void remove_field(std::string& text, const std::string& field) {
    for (const char end : {',', '}'}) replace_all(text, ", " + field + end, std::string(1, end));
}

/// Without the fields of a material, a surface and a light that have their default values.
std::string without_defaults(std::string text) {
    for (const char* field : {".mirror = 0", ".shininess = 32", ".specular = 0", ".error = 0"})
        remove_field(text, field);
    const std::string white = "Material{.color = {1, 1, 1}";
    replace_all(text, white + ", ", "Material{");
    replace_all(text, white + "}", "Material{}");
    remove_field(text, ".material = Material{}");
    const std::string point_light = ", .radius = 0}";
    for (std::size_t at = 0; (at = text.find(point_light, at)) != std::string::npos; ++at) {
        const std::size_t light = text.rfind("Light{", at);
        const std::size_t sphere = text.rfind("Sphere{", at);
        if (light != std::string::npos && (sphere == std::string::npos || sphere < light))
            text.replace(at, point_light.size(), "}");
    }
    return text;
}

bool is_of_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The text with each decimal number, one with a point or an exponent, as `shown` returns it.
std::string with_numbers(const std::string& text,
                         const std::function<std::string(const std::string&)>& shown) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const bool begins = std::isdigit(static_cast<unsigned char>(text[i])) != 0 &&
                            (i == 0 || (!is_of_name(text[i - 1]) && text[i - 1] != '.'));
        char* end = nullptr;
        if (begins) std::strtod(text.c_str() + i, &end);
        const std::size_t size = begins ? std::size_t(end - (text.c_str() + i)) : 1;
        const std::string piece = text.substr(i, size);
        const bool decimal = begins && piece.find_first_of(".e") != std::string::npos;
        out += decimal ? shown(piece) : piece;
        i += size;
    }
    return out;
}

std::string rounded(const std::string& number, int digits) {
    return formatted("%.*g", digits, std::atof(number.c_str()));
}

/// A number of a call. One that differs a little from a short number keeps its digits, unless that
/// is an error of rounding.
std::string brief_number(const std::string& number) {
    constexpr double rounding = 1e-11;
    const std::string text = rounded(number, call_digits);
    const double value = std::atof(number.c_str());
    const bool is_short = text.size() < std::size_t(call_digits);
    const bool is_near = std::abs(std::atof(text.c_str()) - value) <= rounding * std::abs(value);
    if (is_short && !is_near) return number;
    return text;
}

/// "0.5" for "Real(0.5)", and "0" for its −0.
std::string without_casts(std::string text) {
    for (std::size_t at = 0; (at = text.find("Real(", at)) != std::string::npos;) {
        const std::size_t end = text.find(')', at);
        const std::string number = text.substr(at + 5, end - at - 5);
        const bool is_number = number.find_first_not_of("0123456789.e+-") == std::string::npos;
        if (end == std::string::npos || !is_number || (at > 0 && is_of_name(text[at - 1])))
            ++at;
        else
            text.replace(at, end + 1 - at, number == "-0.0" || number == "-0" ? "0" : number);
    }
    return text;
}

/// The first digits in which the answers of the two lines differ, if they do.
int digits_to_tell_apart(const std::string& got, const std::string& expected) {
    const auto answer = [](const std::string& line, int digits) {
        const std::size_t start = line.find_first_not_of(' ', line.find(':') + 1);
        return with_digits(line.substr(std::min(start, line.size())), digits);
    };
    int digits = least_digits;
    while (digits < most_digits && answer(got, digits) == answer(expected, digits)) ++digits;
    return digits;
}

/// "  got:      …", and not a line that goes on from the one before.
bool starts_entry(const std::string& line) {
    return line.starts_with("  ") && !line.starts_with("    ");
}

/// True for the entries by which the question is asked again: the line to paste and the seed.
bool is_for_later(const std::string& line) {
    return line.starts_with("  paste: ") || line.starts_with("  random: ");
}

/// True for a sentence after the answer, "  which has a hit at t = …": an entry without a label.
bool is_sentence(const std::string& line) {
    return starts_entry(line) && line.substr(0, line.find(' ', 2)).find(':') == std::string::npos;
}

}  // namespace

std::string with_digits(const std::string& text, int digits) {
    return with_numbers(text,
                        [digits](const std::string& number) { return rounded(number, digits); });
}

std::string brief_code(const std::string& code) {
    return with_numbers(without_casts(without_defaults(code)), brief_number);
}

std::vector<std::string> failure_lines(const std::string& failure, bool complete) {
    const std::vector<std::string> lines = lines_of(failure);
    const auto got = std::ranges::find_if(lines, starts_answer);
    const int digits = got == lines.end() || got + 1 == lines.end()
                           ? most_digits
                           : digits_to_tell_apart(*got, *(got + 1));
    std::vector<std::string> shown;
    bool is_call = true;
    bool is_later = false;
    for (const std::string& line : lines) {
        is_call = is_call && !starts_entry(line);
        if (starts_entry(line)) is_later = is_for_later(line);
        if (is_later && !complete) continue;
        if (starts_answer(line))
            shown.push_back(with_digits(without_casts(line), digits));
        else
            shown.push_back(is_call || is_sentence(line) ? brief_code(line) : line);
    }
    return shown;
}

bool starts_answer(const std::string& line) {
    return line.starts_with("  got: ") || line.starts_with("  expected: ");
}

std::string fitted(const std::string& text, std::size_t most, const std::string& mark) {
    const std::vector<std::string> lines = lines_of(text);
    if (lines.size() <= most) return text;
    std::string shown;
    for (std::size_t i = 0; i < std::max(most, std::size_t(2)) - 1; ++i) shown += lines[i] + "\n";
    return shown + mark + "\n";
}

std::size_t length_of_call(const std::string& failure) {
    std::size_t length = 0;
    for (const std::string& line : lines_of(failure)) {
        if (starts_answer(line)) break;
        length += line.size() - std::min(line.find_first_not_of(' '), line.size());
    }
    return length;
}

}  // namespace rt
