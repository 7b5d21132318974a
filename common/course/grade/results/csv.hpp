// Tables for spreadsheets and learning platforms: RFC 4180.
#pragma once

#include "common/system/files.hpp"

#include <string>
#include <vector>

namespace rt::grade {

struct Csv {
    struct Row {
        int line = 0;  ///< in the file
        std::vector<std::string> cells;

        /// Nothing if the row is shorter.
        [[nodiscard]] std::string at(int column) const;
    };
    fs::path file;
    char separator = ',';
    bool marked = false;  ///< it begins with a byte order mark, as spreadsheets need it
    Row head;
    std::vector<Row> rows;  ///< below the headings; without blank lines

    /// The column with one of these headings, in capitals or not; -1 if there is none.
    [[nodiscard]] int column(const std::vector<std::string>& headings) const;

    /// The same; throws InputError if there is none, with the headings that are there.
    [[nodiscard]] int wanted(const std::vector<std::string>& headings) const;
};

/// As RFC 4180 requires.
inline constexpr const char* end_of_line = "\r\n";

/// "\"Identifier\", \"Full name\"", for a message.
[[nodiscard]] std::string enumerated(const std::vector<std::string>& headings);

/// The separator is the comma, semicolon or tab that is most frequent in the first line outside of
/// quotes, or that of Excel's own first line, "sep=;". A quote may follow blanks. Throws InputError
/// if the file cannot be read, or a quote is not closed.
[[nodiscard]] Csv read_csv(const fs::path& file);

/// The text with an apostrophe before it if a spreadsheet would evaluate it as a formula.
[[nodiscard]] std::string no_formula(const std::string& text);

/// A cell that no spreadsheet evaluates as a formula.
[[nodiscard]] std::string cell(const std::string& text);

/// The cell unchanged, for programs that do not evaluate formulas.
[[nodiscard]] std::string plain_cell(const std::string& text, char separator = ',');

// Text files that lecturers and spreadsheets write, in any of their encodings.

struct AnyText {
    std::string text;     ///< UTF-8 without a byte order mark; LF for CR in a text without LF
    bool marked = false;  ///< the file has a byte order mark, or is not UTF-8
};

/// Reads UTF-8, UTF-16 with a byte order mark, or else Windows' code page 1252. Throws InputError
/// if the file cannot be read.
[[nodiscard]] AnyText read_any_text(const fs::path& file);

}  // namespace rt::grade
