// Tables for spreadsheets and learning platforms: RFC 4180.
#pragma once

#include <filesystem>
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
    std::filesystem::path file;
    char separator = ',';
    Row head;
    std::vector<Row> rows;  ///< below the headings; without blank lines

    /// The column with one of these headings, ignoring case; -1 if there is none.
    [[nodiscard]] int column(const std::vector<std::string>& headings) const;
};

/// The text of a lecturer's file: without a byte order mark, and with LF for CR in a text without
/// LF. Throws InputError if it cannot be read.
[[nodiscard]] std::string read_any_text(const std::filesystem::path& file);

/// The separator is the comma, semicolon or tab that is most frequent in the first line. Throws
/// InputError if the file cannot be read, or a quote is not closed.
[[nodiscard]] Csv read_csv(const std::filesystem::path& file);

/// A cell that no spreadsheet evaluates as a formula.
[[nodiscard]] std::string cell(const std::string& text);

/// The cell unchanged, for programs that do not evaluate formulas.
[[nodiscard]] std::string plain_cell(const std::string& text, char separator = ',');

}  // namespace rt::grade
