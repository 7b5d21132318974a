// A class, graded.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <vector>

namespace rt::grade {

/// What the command line asks for.
struct Order {
    std::filesystem::path project;
    std::filesystem::path build;
    std::vector<std::filesystem::path> places;  ///< submissions, or folders of submissions
    std::filesystem::path results;
    std::optional<std::filesystem::path>
        seed_file;         ///< else the seed of the run before, or a new one
    std::set<int> stages;  ///< all that are built, if it is empty
    int jobs = 1;
    int part = 1;  ///< of so many that grade the class together, in one folder of results
    int parts = 1;
    bool one = false;                ///< the places are one submission, whatever is in them
    std::set<std::string> students;  ///< all, if it is empty
};

/// What came of it.
enum class Outcome {
    judged,       ///< all
    interrupted,  ///< by Ctrl-C or SIGTERM
    failed,       ///< at some submissions, which standard error has named
};

/// Judges what there is no mark for yet, on so many threads. Throws InputError for what is wrong
/// with the order; ProgramError if the seal does not hold, or the references fail.
[[nodiscard]] Outcome grade(const Order& order);

/// Writes the reports of all marks that there are. Throws InputError.
void write_reports(const std::filesystem::path& results, const std::filesystem::path& project);

}  // namespace rt::grade
