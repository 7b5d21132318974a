// The submissions of a class: a folder of folders and archives, as collected by a lecturer or
// packed by a learning platform.
#pragma once

#include "common/course/grade/judging/intake.hpp"
#include "common/system/files.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

struct ClassFolder {
    std::vector<Submission> submissions;  ///< in the order of their places
    std::vector<std::string> left_over;   ///< files that belong to no submission, with the reason:
                                          ///< "list.txt: …"
    std::vector<std::string> taken_as;    ///< whose submissions each place contains: "anna.zip is
                                          ///< taken as one submission, of anna"
    std::map<fs::path, std::vector<std::string>>
        classes;  ///< the students of the folders that look like a class
};

/// Each place is a submission, or a folder of submissions, which are folders and archives. An
/// archive is one submission, whatever names it contains, unless `archives_are_classes`: then an
/// archive at a place, or alone in the folder there, is unpacked in the workshop and contains
/// submissions. Folders of results, of this run or another, are left out. Names by Moodle and
/// Canvas are recognized in folders, archives and plain files: "Zoe
/// Doe_123_assignsubmission_file_", "doezoe_LATE_123_456_sphere.cpp". Students' names stay
/// different on case-insensitive file systems too. Throws InputError if a place does not exist,
/// contains no submission, or may be either a class or a submission.
[[nodiscard]] ClassFolder find_class(const BuildDirectory& workshop,
                                     const std::vector<fs::path>& places,
                                     const fs::path& results = {},
                                     bool archives_are_classes = false);

/// All places belong to one student. Throws InputError.
[[nodiscard]] ClassFolder one_submission(const std::vector<fs::path>& places);

/// A student's name, made safe for a folder, a page and a table.
[[nodiscard]] std::string plain_name(const std::string& name);

}  // namespace rt::grade
