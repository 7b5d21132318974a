#include "common/mesh_file/mesh_lines.hpp"

#include "common/system/escaping.hpp"
#include "common/system/parse_floating.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace rt {

namespace {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

}  // namespace

void blank_byte_order_mark(std::string& content) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (content.starts_with(mark)) std::fill_n(content.begin(), mark.size(), ' ');
}

void plain_text(std::string& content) {
    blank_byte_order_mark(content);
    for (const char odd : {'\v', '\f'}) {
        for (auto at = content.find(odd); at != std::string::npos; at = content.find(odd, at)) {
            content[at] = ' ';
        }
    }
    if (!content.ends_with('\n')) content += '\n';
}

std::optional<std::string_view> MeshLines::next() {
    while (position_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', position_), text_.size());
        auto line = std::string_view(text_).substr(position_, end - position_);
        position_ = end + 1;
        ++number_;
        while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
        if (!line.empty()) return line;
    }
    position_ = text_.size();
    return std::nullopt;
}

void MeshLines::refuse(const std::string& message) const {
    throw InputError({file_, number_}, message);
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
    std::int64_t value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size()) return std::nullopt;
    return value;
}

std::optional<float> float_number(std::string_view word) {
    float value = 0;
    const char* const last = word.data() + word.size();
    const auto [end, error] = parse_floating(word, value);
    if (error == std::errc() && end == last && std::isfinite(value)) return value;
    // It rejects "+1", and numbers near 0 that round to 0. (strtof also accepts "0x1p3".)
    constexpr std::string_view allowed = "0123456789+-.eE";
    if (word.find_first_not_of(allowed) != std::string_view::npos) return std::nullopt;
    const std::string text(word);
    char* rest = nullptr;
    value = std::strtof(text.c_str(), &rest);
    if (text.empty() || rest != text.c_str() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

void require_three_numbers(std::string_view& line, const char* what, const MeshLines& lines) {
    for (int i = 0; i < 3; ++i) {
        const std::string_view word = take_word(line);
        if (float_number(word)) continue;
        lines.refuse(std::string(what) + " must be three numbers up to 3.4e38, not " +
                     quoted(word));
    }
}

}  // namespace rt
