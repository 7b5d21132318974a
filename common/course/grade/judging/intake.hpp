// The files of a submission: untrusted folders and archives.
#pragma once

#include "common/course/grade/judging/workshop.hpp"
#include "common/system/files.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// A file, a folder or an archive of one student.
struct Piece {
    fs::path place;
    std::string name;  ///< the student's file name, without a learning platform's prefix
};

/// All of a student's files, unopened.
struct Submission {
    std::string student;  ///< safe as the name of a folder
    std::vector<Piece> pieces;
};

/// "Bob_Ray_124, Zoe_Doe_123 and 20 more": the first six names.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// True for the output of this run or an earlier one, which may be among the submissions or inside
/// one. It contains files of other students.
[[nodiscard]] bool is_results(const fs::path& folder);

/// The contents of a submission.
struct SubmittedFiles {
    std::map<GradedFile, std::string> files;
    std::map<GradedFile, std::string> words;  ///< notes: two files for one, names that nearly match
    std::string words_on_all;                 ///< notes on archives that cannot be opened
};

/// Collects the files with the thirteen names, in any folder or archive, and main.cpp, the `trace`
/// of the stage that its folder names, or whose file is the only one beside it. The order of
/// preference for several files of one stage: a file in a folder "student", then the least deep
/// one; last, files in a folder "tests" or "build", and after them files with a similar name
/// ("Sphere.cpp"). Links are not followed, and archives are opened only in the sandbox. Throws
/// ProgramError or filesystem_error if the grader itself fails.
[[nodiscard]] SubmittedFiles take_in(const BuildDirectory& workshop, const Submission& submission);

}  // namespace rt::grade
