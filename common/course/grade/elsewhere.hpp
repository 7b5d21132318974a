// `./course grade --for …`: what grades a class on machines that are not this one.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace rt::grade {

/// Writes into the folder what the place needs:
///
/// gradescope   autograder.zip, to be uploaded: the project, setup.sh and run_autograder
/// github       grade.yml, a workflow for .github/workflows of a private clone of the project
/// slurm        submit.sh CLASS OUT, an array of jobs and the reports after it; and the same
///              for GNU parallel, in_parallel.sh
///
/// On Gradescope these stages are graded; all, if there are none. Throws InputError if the place is
/// none of these, or a file cannot be written; ProgramError if the project is not packed.
void write_for(const std::string& place, const std::filesystem::path& folder,
               const std::filesystem::path& project, const std::set<int>& stages);

}  // namespace rt::grade
