// The corpus' own table, and the project's list of files that it reads otherwise.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt {

/// The verdict on a file by the letter of the published format.
struct Verdict {
    std::string file;  ///< from the folder of the corpus
    std::string kind;  ///< valid-old, valid-new, extended or invalid
    std::string reason;
    std::string line;
    bool ordinary = true;  ///< its author does not announce an error
    std::string note;
};

/// The rows of verdicts.tsv. Throws InputError for a row without its six columns.
[[nodiscard]] std::vector<Verdict> read_verdicts(const std::filesystem::path& table);

/// File and why, of a table with these two columns.
[[nodiscard]] std::map<std::string, std::string> read_explanations(
    const std::filesystem::path& table);

}  // namespace rt
