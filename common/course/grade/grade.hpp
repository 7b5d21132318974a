// The grading of a class.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <vector>

namespace rt::grade {

/// The options of the command line.
struct Order {
    std::filesystem::path project;
    std::filesystem::path build;
    std::vector<std::filesystem::path> places;  ///< submissions, or folders of submissions
    std::filesystem::path results;
    std::optional<std::filesystem::path>
        seed_file;         ///< if empty, the seed of the previous run, or a new one
    std::set<int> stages;  ///< all built stages if empty
    int jobs = 1;
    int part = 1;  ///< this process is one of `parts` that grade the class together, in one folder
                   ///< of results
    int parts = 1;
    bool one = false;       ///< the places are one submission, whatever they contain
    bool is_class = false;  ///< an archive is a class and not a submission
    std::set<std::string>
        students;  ///< by their names in the results or on the roster; all if empty
};

/// The outcome of a run.
enum class Outcome {
    judged,       ///< all submissions
    interrupted,  ///< by Ctrl-C or SIGTERM
    failed,       ///< at some submissions, which standard error lists
};

/// Grades the submissions without marks, on `jobs` threads. Throws InputError for a wrong order;
/// ProgramError if the sandbox does not work, or the references fail.
[[nodiscard]] Outcome grade(const Order& order);

/// Reads the translations of what is printed, into the language of the terminal.
void read_terminal_language(const std::filesystem::path& project);

/// Writes the reports of all existing marks, in the language of the class, and Gradescope's file if
/// it has a name. Throws InputError.
void write_reports(const std::filesystem::path& results, const std::filesystem::path& project,
                   const std::filesystem::path& gradescope = {});

}  // namespace rt::grade
