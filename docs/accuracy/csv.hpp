// What a study has measured: lines of words with commas between them, the first naming the columns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt::accuracy {

using Row = std::map<std::string, std::string>;

/// The rows of a file, in its order. Throws InputError if it cannot be read.
[[nodiscard]] std::vector<Row> read_csv(const std::filesystem::path& file);

[[nodiscard]] double number(const Row& row, const std::string& column);

/// Those whose columns have these words.
[[nodiscard]] std::vector<Row> where(const std::vector<Row>& rows, const Row& words);

/// The different words of a column, in the order in which they first come.
[[nodiscard]] std::vector<std::string> different(const std::vector<Row>& rows,
                                                 const std::string& column);

/// The middle one of the values. Throws InputError if there is none.
[[nodiscard]] double median(std::vector<double> values);

/// The median of a column over rows of several turns.
[[nodiscard]] double middle(const std::vector<Row>& rows, const std::string& column);

}  // namespace rt::accuracy
