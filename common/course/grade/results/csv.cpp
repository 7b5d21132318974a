#include "common/course/grade/results/csv.hpp"

#include "common/course/grade/results/student_names.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/text.hpp"

#include <utf8proc.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace rt::grade {

namespace {

/// Also in full width, and after blanks: some spreadsheets read these alike.
bool is_formula(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
    for (const std::string_view start : {"=", "+", "-", "@", "＝", "＋", "－", "＠"})
        if (text.starts_with(start)) return true;
    return false;
}

std::string quoted(std::string text) {
    replace_all(text, "\"", "\"\"");
    return "\"" + text + "\"";
}

/// The most frequent separator of the first line, outside of quotes.
char separator_of(const std::string& text) {
    std::string first;
    bool is_quoted = false;
    for (const char each : text) {
        if (each == '"') is_quoted = !is_quoted;
        if (each == '\n' && !is_quoted) break;
        if (!is_quoted) first += each;
    }
    const std::string separators = ",;\t";
    return *std::ranges::max_element(
        separators, {}, [&](char separator) { return std::ranges::count(first, separator); });
}

/// The separator of Excel's own first line, "sep=;"; or nothing.
std::optional<char> named_separator(const std::string& text) {
    const std::string first = trimmed(text.substr(0, text.find('\n')));
    const bool is_named = first.size() == 5 && lower_case(first).starts_with("sep=");
    return is_named ? std::optional(first.back()) : std::nullopt;
}

/// A heading that may have a line break, in capitals or not.
std::string title(std::string heading) {
    std::erase(heading, '\r');
    return folded(heading);
}

bool is_blank(const std::string& text) {
    return text.find_first_not_of(" \t") == std::string::npos;
}

}  // namespace

std::string Csv::Row::at(int column) const {
    return column >= 0 && column < int(cells.size()) ? cells[std::size_t(column)] : "";
}

int Csv::column(const std::vector<std::string>& headings) const {
    for (const std::string& heading : headings)
        for (std::size_t i = 0; i < head.cells.size(); ++i)
            if (!heading.empty() && title(head.cells[i]) == title(heading)) return int(i);
    return -1;
}

int Csv::wanted(const std::vector<std::string>& headings) const {
    if (const int found = column(headings); found != -1) return found;
    throw InputError({file.string(), head.line},
                     "has no column \"" + headings.front() + "\", but " + enumerated(head.cells));
}

Csv read_csv(const fs::path& file) {
    const auto [text, marked] = read_any_text(file);
    const std::optional<char> named = named_separator(text);
    Csv csv{.file = file, .separator = named ? *named : separator_of(text), .marked = marked};
    std::vector<Csv::Row> rows;
    int line = named ? 2 : 1;
    Csv::Row row{.line = line};
    std::string cell;
    const auto end_row = [&] {
        row.cells.push_back(std::move(cell));
        cell.clear();
        if (row.cells.size() > 1 || !row.cells[0].empty()) rows.push_back(std::move(row));
        row = {.line = line};
    };
    for (std::size_t i = named ? std::min(text.find('\n'), text.size() - 1) + 1 : 0;
         i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') ++line;
        if (c == '"' && is_blank(cell)) {
            const int start = line;
            cell.clear();
            for (++i;; ++i) {
                if (i >= text.size())
                    throw InputError({file.string(), start}, "this quote is not closed");
                if (text[i] == '"' && (i + 1 == text.size() || text[i + 1] != '"')) break;
                if (text[i] == '"') ++i;
                if (text[i] == '\n') ++line;
                cell += text[i];
            }
        } else if (c == csv.separator) {
            row.cells.push_back(std::move(cell));
            cell.clear();
        } else if (c == '\n') {
            end_row();
        } else if (c != '\r') {
            cell += c;
        }
    }
    if (!cell.empty() || !row.cells.empty()) end_row();
    if (rows.empty()) throw InputError({file.string()}, "is empty");
    csv.head = std::move(rows.front());
    csv.rows.assign(std::make_move_iterator(rows.begin() + 1), std::make_move_iterator(rows.end()));
    return csv;
}

std::string enumerated(const std::vector<std::string>& headings) {
    return joined(headings, [](const std::string& each) { return "\"" + each + "\""; });
}

std::string no_formula(const std::string& text) {
    return is_formula(text) ? "'" + text : text;
}

std::string cell(const std::string& text) {
    const std::string plain = no_formula(readable(text));
    return plain.find_first_of(",;\"\n\t") == std::string::npos ? plain : quoted(plain);
}

std::string plain_cell(const std::string& text, char separator) {
    const bool plain = text.find_first_of("\"\r\n") == std::string::npos &&
                       text.find(separator) == std::string::npos;
    return plain ? text : quoted(text);
}

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

unsigned byte(char c) {
    return static_cast<unsigned char>(c);
}

void append(std::string& text, unsigned code) {
    std::array<utf8proc_uint8_t, 4> bytes{};
    const auto size = utf8proc_encode_char(utf8proc_int32_t(code), bytes.data());
    text.append(reinterpret_cast<const char*>(bytes.data()), std::size_t(size));
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        utf8proc_int32_t code = 0;
        const auto size = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                                           utf8proc_ssize_t(text.size()), &code);
        if (size <= 0) return false;
        text.remove_prefix(std::size_t(size));
    }
    return true;
}

/// https://www.unicode.org/Public/MAPPINGS/VENDORS/MICSFT/WINDOWS/CP1252.TXT
std::string from_windows(std::string_view bytes) {
    constexpr std::array<unsigned, 32> from_80 = {
        0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
        0x2039, 0x0152, 0x8d,   0x017d, 0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
        0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};
    std::string text;
    for (const char c : bytes) {
        const unsigned code = byte(c);
        append(text, 0x80 <= code && code < 0xa0 ? from_80.at(code - 0x80) : code);
    }
    return text;
}

std::string from_utf16(std::string_view bytes, bool big_end_first) {
    const auto unit = [&](std::size_t i) {
        const unsigned one = byte(bytes[i]);
        const unsigned two = byte(bytes[i + 1]);
        return big_end_first ? one << 8 | two : two << 8 | one;
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        unsigned code = unit(i);
        const bool is_first_half = 0xd800 <= code && code < 0xdc00 && i + 3 < bytes.size();
        if (is_first_half) code = 0x10000 + ((code & 0x3ff) << 10 | (unit(i += 2) & 0x3ff));
        append(text, code);
    }
    return text;
}

}  // namespace

AnyText read_any_text(const fs::path& file) {
    AnyText read{.text = read_text(file)};
    std::string& text = read.text;
    const std::string_view bytes = text;
    read.marked = true;
    if (bytes.starts_with(byte_order_mark))
        text.erase(0, byte_order_mark.size());
    else if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
        text = from_utf16(bytes.substr(2), bytes[0] == '\xfe');
    else if (!is_utf8(bytes))
        text = from_windows(bytes);
    else
        read.marked = false;
    if (text.find('\n') == std::string::npos) std::ranges::replace(text, '\r', '\n');
    return read;
}

}  // namespace rt::grade
