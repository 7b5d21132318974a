// Tables as spreadsheets and learning platforms write and read them: RFC 4180.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

struct Csv {
    struct Row {
        int line = 0;  ///< of the file
        std::vector<std::string> cells;

        /// Nothing if the row is shorter.
        [[nodiscard]] std::string at(int column) const;
    };
    std::filesystem::path file;
    char separator = ',';
    Row head;
    std::vector<Row> rows;  ///< below it; blank lines are none

    /// The column of one of these headings, in upper or lower case; -1 if there is none.
    [[nodiscard]] int column(const std::vector<std::string>& headings) const;
};

/// Separated by comma, semicolon or tab, whichever the first line has most of. Throws InputError if
/// the file cannot be read, or a quote is not closed.
[[nodiscard]] Csv read_csv(const std::filesystem::path& file);

/// A cell that no spreadsheet takes for a formula.
[[nodiscard]] std::string cell(const std::string& text);

/// The same, but as it is: for a program that knows it.
[[nodiscard]] std::string plain_cell(const std::string& text, char separator = ',');

}  // namespace rt::grade
