#include "common/course/grade/results/csv.hpp"

#include "common/course/grade/results/any_text.hpp"
#include "common/course/grade/results/student_names.hpp"

#include "common/system/input_error.hpp"
#include "common/system/lower_case.hpp"
#include "common/system/readable.hpp"

#include <algorithm>
#include <optional>

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
    for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2))
        text.insert(at, "\"");
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
    return *std::max_element(separators.begin(), separators.end(), [&](char one, char other) {
        return std::count(first.begin(), first.end(), one) <
               std::count(first.begin(), first.end(), other);
    });
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

Csv read_csv(const std::filesystem::path& file) {
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
    std::string all;
    for (const std::string& each : headings) all += (all.empty() ? "\"" : ", \"") + each + "\"";
    return all;
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

}  // namespace rt::grade
