// `./course handout`: the students' copy of the project.
#pragma once

#include "common/course/handout/selection.hpp"
#include "common/system/files.hpp"

#include <string>
#include <vector>

namespace rt {

/// Writes everything that students need, without solutions: the references only as archives of
/// objects, built for machines like this one, and for those with `also` other kinds of processor
/// ("aarch64"), if Debian's cross compiler for them is installed; no known mistakes, no other right
/// answers, no tests of the project itself. The destination is a folder, or an archive if the name
/// ends in .tar.gz; it is written whole or not at all. Returns 0. Throws InputError on failure, or
/// if the destination exists.
int hand_out(const fs::path& destination, const std::vector<std::string>& also,
             const Selection& selection);

// `./course update`: the update of a student's copy to a newer hand-out.

/// Copies the files of a newer hand-out, a folder or an archive, and removes files that it no
/// longer contains. The student's own files stay: their stages unchanged, and changed files of the
/// hand-out under another name. After an interruption, the same command completes the update.
/// Prints the changes. Returns 0. Throws InputError, before anything is changed, if one of the two
/// is not a hand-out.
int update(const fs::path& newer);

/// Prints a warning if an update of this copy was interrupted.
void warn_of_half_update();

}  // namespace rt
