// The grading of a class.
#pragma once

#include "common/system/files.hpp"

#include <optional>
#include <set>
#include <vector>

namespace rt::grade {

/// The options of the command line.
struct Order {
    fs::path project;
    fs::path build;
    std::vector<fs::path> places;  ///< submissions, or folders of submissions
    fs::path results;
    std::optional<fs::path> seed_file;  ///< if empty, the seed of the previous run, or a new one
    std::set<int> stages;               ///< all built stages if empty
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
void read_terminal_language(const fs::path& project);

/// Writes the reports of all existing marks, in the language of the class, and Gradescope's file if
/// it has a name. Throws InputError.
void write_reports(const fs::path& results, const fs::path& project,
                   const fs::path& gradescope = {});

// `./course grade --for …`: files that run the grading on another machine.

/// Writes the place's files into the folder:
///
/// gradescope   autograder.zip, to be uploaded: the project, setup.sh and run_autograder
/// github       grade.yml, a workflow for .github/workflows of a private clone of the project
/// slurm        submit.sh CLASS OUT, an array of jobs and then the reports; and in_parallel.sh,
///              the same for GNU parallel
///
/// On Gradescope only `stages` are graded; all of them if it is empty. Throws InputError if the
/// place is unknown, a file exists with other content (autograder.zip: if it exists), or one cannot
/// be written; ProgramError if the project cannot be packed.
void write_for(const std::string& place, const fs::path& folder, const fs::path& project,
               const std::set<int>& stages);

}  // namespace rt::grade
