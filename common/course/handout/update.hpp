// `./course update`: the update of a student's copy to a newer hand-out.
#pragma once

#include <filesystem>

namespace rt {

/// Copies the files of a newer hand-out, a folder or an archive, and removes files that it no
/// longer contains. The student's own files stay: their stages unchanged, and changed files of the
/// hand-out under another name. After an interruption, the same command completes the update.
/// Prints the changes. Returns 0. Throws InputError, before anything is changed, if one of the two
/// is not a hand-out.
int update(const std::filesystem::path& newer);

/// Prints a warning if an update of this copy was interrupted.
void warn_of_half_update();

}  // namespace rt
