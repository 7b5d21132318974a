#include "docs/accuracy/csv.hpp"

#include "common/input_error.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace rt::accuracy {

namespace {

std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream in(line);
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

}  // namespace

std::vector<Row> read_csv(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) throw InputError({.file = file.string()}, "cannot be read");
    const std::vector<std::string> columns = words_of(line);
    std::vector<Row> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> words = words_of(line);
        if (words.size() != columns.size())
            throw InputError({.file = file.string(), .line = int(rows.size()) + 2},
                             "has not as many words as there are columns");
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = words[i];
    }
    return rows;
}

double number(const Row& row, const std::string& column) {
    return std::stod(row.at(column));
}

std::vector<Row> where(const std::vector<Row>& rows, const Row& words) {
    std::vector<Row> found;
    for (const Row& row : rows)
        if (std::ranges::all_of(words, [&](const auto& w) { return row.at(w.first) == w.second; }))
            found.push_back(row);
    return found;
}

std::vector<std::string> different(const std::vector<Row>& rows, const std::string& column) {
    std::vector<std::string> words;
    for (const Row& row : rows)
        if (std::ranges::find(words, row.at(column)) == words.end())
            words.push_back(row.at(column));
    return words;
}

double median(std::vector<double> values) {
    if (values.empty())
        throw InputError({.file = "docs/accuracy"}, "one file has what another has not");
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

double middle(const std::vector<Row>& rows, const std::string& column) {
    std::vector<double> values;
    for (const Row& row : rows) values.push_back(number(row, column));
    return median(values);
}

}  // namespace rt::accuracy
