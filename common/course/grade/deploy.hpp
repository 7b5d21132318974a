// `./course grade --for …`: files that run the grading on another machine.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace rt::grade {

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
void write_for(const std::string& place, const std::filesystem::path& folder,
               const std::filesystem::path& project, const std::set<int>& stages);

}  // namespace rt::grade
