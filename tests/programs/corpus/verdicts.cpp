#include "tests/programs/corpus/verdicts.hpp"

#include "common/system/input_error.hpp"

#include <fstream>
#include <string_view>

namespace rt {

namespace {

std::vector<std::string> cells(std::string_view row) {
    std::vector<std::string> found;
    while (true) {
        const std::size_t tab = row.find('\t');
        found.emplace_back(row.substr(0, tab));
        if (tab == std::string_view::npos) return found;
        row.remove_prefix(tab + 1);
    }
}

/// The rows after the heading, each with that many cells.
std::vector<std::vector<std::string>> rows(const std::filesystem::path& table,
                                           std::size_t columns) {
    std::ifstream stream(table);
    if (!stream) throw InputError({table.string()}, "cannot be read");
    std::vector<std::vector<std::string>> found;
    std::string row;
    std::getline(stream, row);
    for (int line = 2; std::getline(stream, row); ++line) {
        found.push_back(cells(row));
        if (found.back().size() == columns) continue;
        throw InputError({table.string(), line},
                         "expected " + std::to_string(columns) + " cells with tabs between");
    }
    return found;
}

}  // namespace

std::vector<Verdict> read_verdicts(const std::filesystem::path& table) {
    std::vector<Verdict> verdicts;
    for (const auto& row : rows(table, 6)) {
        verdicts.push_back({.file = row[0],
                            .kind = row[1],
                            .reason = row[2],
                            .line = row[3],
                            .ordinary = row[4] == "ordinary",
                            .note = row[5]});
    }
    return verdicts;
}

std::map<std::string, std::string> read_explanations(const std::filesystem::path& table) {
    std::map<std::string, std::string> explanations;
    for (const auto& row : rows(table, 2)) explanations.emplace(row[0], row[1]);
    return explanations;
}

}  // namespace rt
