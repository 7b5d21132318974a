#include "common/mesh_file/mesh_lines.hpp"

#include "common/system/escaping.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace rt {

namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

constexpr bool is_digit(char c) {
    return '0' <= c && c <= '9';
}

inline void skip_blanks(std::string_view& line) {
    std::size_t blanks = 0;
    while (blanks < line.size() && is_blank(line[blanks])) ++blanks;
    line.remove_prefix(blanks);
}

/// The word without a plus sign before its digits.
inline std::string_view without_plus(std::string_view word) {
    return word.substr(word.size() > 1 && word[0] == '+' && is_digit(word[1]));
}

/// Removes what was parsed from the line. Returns false, and removes nothing, if that is not a
/// whole word.
bool take_parsed(std::string_view& line, const std::from_chars_result& parsed) {
    const char* const last = line.data() + line.size();
    if (parsed.ec != std::errc() || (parsed.ptr != last && !is_blank(*parsed.ptr))) return false;
    line = {parsed.ptr, std::size_t(last - parsed.ptr)};
    return true;
}

glm::dvec3 take_three(std::string_view& line, const char* what, const MeshLines& lines,
                      std::optional<double> (*take)(std::string_view& line)) {
    glm::dvec3 result(0);
    for (int i = 0; i < 3; ++i) {
        const auto number = take(line);
        if (!number) {
            lines.refuse(std::string(what) + " must be three numbers up to 3.4e38, not " +
                         quoted(take_word(line)));
        }
        result[i] = *number;
    }
    return result;
}

}  // namespace

void blank_byte_order_mark(std::string& content) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (content.starts_with(mark)) std::fill_n(content.begin(), mark.size(), ' ');
}

void plain_text(std::string& content) {
    blank_byte_order_mark(content);
    for (const char odd : {'\v', '\f'}) std::ranges::replace(content, odd, ' ');
    if (content.find('\n') == std::string::npos) std::ranges::replace(content, '\r', '\n');
}

void blank_comments(std::string& content, std::size_t from) {
    for (auto at = content.find('#', from); at != std::string::npos; at = content.find('#', at)) {
        const auto end = std::min(content.find('\n', at), content.size());
        std::fill(content.begin() + static_cast<std::ptrdiff_t>(at),
                  content.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }
}

std::optional<std::string_view> MeshLines::next_of_any_kind() {
    if (position_ >= text_.size()) return std::nullopt;
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    auto line = text_.substr(position_, end - position_);
    position_ = std::min(end + 1, text_.size());
    ++number_;
    skip_blanks(line);
    return line;
}

std::optional<std::string_view> MeshLines::next() {
    auto line = next_of_any_kind();
    while (line && line->empty()) line = next_of_any_kind();
    return line;
}

void MeshLines::refuse(const std::string& message) const {
    throw InputError({file_, number_}, message);
}

void MeshLines::refuse_end(std::uint64_t read, std::uint64_t count,
                           const std::string& items) const {
    refuse("the file ends after " + std::to_string(read) + " of " + std::to_string(count) + " " +
           items + ": each needs a line of its own");
}

std::string_view take_word(std::string_view& line) {
    std::size_t begin = 0;
    while (begin < line.size() && is_blank(line[begin])) ++begin;
    std::size_t end = begin;
    while (end < line.size() && !is_blank(line[end])) ++end;
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

std::size_t count_words(std::string_view line) {
    std::size_t count = 0;
    bool was_blank = true;
    for (const char c : line) {
        count += was_blank && !is_blank(c);
        was_blank = is_blank(c);
    }
    return count;
}

std::optional<std::int64_t> whole_number(std::string_view word) {
    word = without_plus(word);
    std::int64_t value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size()) return std::nullopt;
    return value;
}

std::optional<std::int64_t> take_whole_number(std::string_view& line) {
    skip_blanks(line);
    // Most have few digits, and nothing else: this takes half the time of std::from_chars.
    std::int64_t small = 0;
    const std::size_t most = std::min(line.size(), std::size_t(9));
    std::size_t end = 0;
    for (; end < most && is_digit(line[end]); ++end) small = 10 * small + (line[end] - '0');
    if (end > 0 && take_parsed(line, {line.data() + end, std::errc()})) return small;

    const std::string_view digits = without_plus(line);
    std::int64_t value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (!take_parsed(line, parsed)) return std::nullopt;
    return value;
}

std::optional<double> take_number(std::string_view& line) {
    skip_blanks(line);
    double value = 0;
    // Most numbers are parsed in the line, without a search for the end of the word before.
    std::string_view rest = line;
    if (!take_parsed(rest, parse_floating(line, value))) {
        // It rejects "+1", and numbers near 0 that round to 0. (strtod also accepts "0x1p3".)
        const std::string word(take_word(rest));
        constexpr const char* allowed = "0123456789+-.eE";
        char* end = nullptr;
        value = std::strtod(word.c_str(), &end);
        if (word.empty() || word.find_first_not_of(allowed) != std::string::npos ||
            end != word.c_str() + word.size())
            return std::nullopt;
    }
    if (!(std::abs(value) <= double(std::numeric_limits<float>::max()))) return std::nullopt;
    line = rest;
    return value;
}

std::optional<double> take_number_or_nan(std::string_view& line) {
    if (const auto number = take_number(line)) return number;
    std::string_view rest = line;
    std::string word = lower_case(std::string(take_word(rest).substr(0, 16)));
    if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
    if (!word.starts_with("nan") && !word.starts_with("inf") && !word.starts_with("1.#"))
        return std::nullopt;
    line = rest;
    return std::numeric_limits<double>::quiet_NaN();
}

glm::dvec3 take_point(std::string_view& line, const char* what, const MeshLines& lines) {
    return take_three(line, what, lines, take_number);
}

glm::dvec3 take_normal(std::string_view& line, const char* what, const MeshLines& lines) {
    return take_three(line, what, lines, [](std::string_view& rest) {
        skip_blanks(rest);
        const double none = std::numeric_limits<double>::quiet_NaN();
        return rest.empty() ? none : take_number_or_nan(rest);
    });
}

void require_no_word(std::string_view rest, const char* what, const MeshLines& lines) {
    std::string_view line = rest;
    const std::string_view word = take_word(line);
    if (word.empty() || take_number_or_nan(rest)) return;
    lines.refuse(std::string(what) + " is on a line of its own, followed here by " + quoted(word));
}

}  // namespace rt
