// Who is in a class: a folder of folders and archives, as a lecturer collects them or as a learning
// platform packs them.
#pragma once

#include "common/course/grade/intake.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

struct ClassFolder {
    std::vector<Envelope> envelopes;     ///< in the order of their places
    std::vector<std::string> left_over;  ///< what is nobody's, and why: "list.txt: …"
};

/// Each of the places is a submission or a class: a folder or archive of submissions, in which a
/// folder of results is none, of this run or another. Moodle's and Canvas's names are known, in
/// folders, in archives and as plain files: "Zoe Doe_123_assignsubmission_file_",
/// "doezoe_LATE_123_456_sphere.cpp". An archive of a class is unpacked in the workshop. Students'
/// names differ, on systems too that take upper for lower case. Throws InputError if a place is not
/// there, or holds no submission, or may be a class as well as a submission.
[[nodiscard]] ClassFolder find_class(const Workshop& workshop,
                                     const std::vector<std::filesystem::path>& places,
                                     const std::filesystem::path& results = {});

/// All of the places are one student's. Throws InputError.
[[nodiscard]] ClassFolder one_submission(const std::vector<std::filesystem::path>& places);

/// A student's name, made fit for a folder, a page and a table.
[[nodiscard]] std::string plain_name(const std::string& name);

}  // namespace rt::grade
