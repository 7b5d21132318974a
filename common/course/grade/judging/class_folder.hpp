// The submissions of a class: a folder of folders and archives, as collected by a lecturer or
// packed by a learning platform.
#pragma once

#include "common/course/grade/judging/intake.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

struct ClassFolder {
    std::vector<Submission> submissions;  ///< in the order of their places
    std::vector<std::string> left_over;   ///< files that belong to no submission, with the reason:
                                          ///< "list.txt: …"
};

/// Each place is a submission or a class: a folder or an archive of submissions. Folders of
/// results, of this run or another, are left out. Names by Moodle and Canvas are recognized in
/// folders, archives and plain files: "Zoe Doe_123_assignsubmission_file_",
/// "doezoe_LATE_123_456_sphere.cpp". An archive of a class is unpacked in the workshop. Students'
/// names stay different on case-insensitive file systems too. Throws InputError if a place does not
/// exist, contains no submission, or may be either a class or a submission.
[[nodiscard]] ClassFolder find_class(const BuildDirectory& workshop,
                                     const std::vector<std::filesystem::path>& places,
                                     const std::filesystem::path& results = {});

/// All places belong to one student. Throws InputError.
[[nodiscard]] ClassFolder one_submission(const std::vector<std::filesystem::path>& places);

/// A student's name, made safe for a folder, a page and a table.
[[nodiscard]] std::string plain_name(const std::string& name);

}  // namespace rt::grade
