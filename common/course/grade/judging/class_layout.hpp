// The look of a class's submissions, in a folder or in an archive.
#pragma once

#include "common/course/grade/judging/workshop.hpp"
#include "common/system/files.hpp"

#include <optional>
#include <set>
#include <vector>

namespace rt::grade {

/// The entries of a folder, sorted, without litter. Throws InputError if it cannot be read.
[[nodiscard]] std::vector<fs::path> entries_of(const fs::path& folder);

/// True for a folder that is no link.
[[nodiscard]] bool is_folder(const fs::path& place);

/// The name of a file or folder, "anna" of "anna/".
[[nodiscard]] std::string last_name(const fs::path& place);

/// The stages with a file anywhere in the folder.
[[nodiscard]] std::set<int> stages_in(const fs::path& folder);

/// True if the top of the folder contains a stage's file, a stage's folder, or "steps".
[[nodiscard]] bool is_submission(const std::vector<fs::path>& entries);

/// The entries that look as Canvas would name them, "tp_3_1_anna.zip", but are not its: Canvas
/// gives each file a number of its own, and of several archives or folders in a class not all are
/// one student's.
[[nodiscard]] std::set<fs::path> without_platform(const std::vector<fs::path>& entries);

/// True if the folders look like several students': two contain a file of the same stage.
[[nodiscard]] bool are_many(const std::vector<fs::path>& entries);

/// An archive as a folder. Only files that may be a student's have contents; the other names are
/// there too, so that no student is lost.
struct LaidOut {
    fs::path folder;                ///< in the workshop
    std::vector<fs::path> entries;  ///< below the folders that contain all others
    bool whole = false;             ///< false if the archive is damaged or too large
};

/// Unpacks files of that total size. Returns nothing if the archive cannot be read at all.
[[nodiscard]] std::optional<LaidOut> lay_out(const BuildDirectory& workshop,
                                             const fs::path& archive, int megabytes);

}  // namespace rt::grade
