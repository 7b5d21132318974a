// `./course book`: the pages of docs/ as a site, with search, hints and contracts in the pages.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace rt {

struct BookSettings {
    std::filesystem::path project;
    std::optional<std::string> out;  ///< the folder for the site; without it, it is served
    std::optional<std::string> pdf;  ///< the folder for the printed pages; nothing is served then
    std::string source;              ///< where links to the project's files lead; empty: to GitHub,
                                     ///< if the project is a clone from there
};

/// Writes the site and prints its name; or serves it, prints its address, and returns at Ctrl-C. A
/// hand-out contains the site already. Throws InputError or ProgramError if it cannot be written.
/// Returns 0.
int book(const BookSettings& settings);

}  // namespace rt
