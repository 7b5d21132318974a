// `./course update`: a newer hand-out in a student's copy.
#pragma once

#include <filesystem>

namespace rt {

/// Brings the files of a newer hand-out, a folder or an archive, and removes what it has no more.
/// What the student has written stays as it is: his stages, and under another name what he has
/// changed of the hand-out. Whoever is interrupted runs it again. Says what has changed. Returns 0.
/// Throws InputError, before anything is touched, if one of the two is no hand-out.
int update(const std::filesystem::path& newer);

/// Says so if an update was interrupted here.
void warn_of_half_update();

}  // namespace rt
