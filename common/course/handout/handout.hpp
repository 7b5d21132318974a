// `./course handout`: the students' copy of the project.
#pragma once

#include "common/course/handout/selection.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// Writes everything that students need, without solutions: the references only as archives of
/// objects, built for machines like this one, and for those with `also` other kinds of processor
/// ("aarch64"), if Debian's cross compiler for them is installed; no known mistakes, no other right
/// answers, no tests of the project itself. The destination is a folder, or an archive if the name
/// ends in .tar.gz; it is written whole or not at all. Returns 0. Throws InputError on failure, or
/// if the destination exists.
int hand_out(const std::filesystem::path& destination, const std::vector<std::string>& also,
             const Selection& selection);

}  // namespace rt
