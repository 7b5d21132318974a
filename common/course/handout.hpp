// `./course handout`: the project as students get it.
#pragma once

#include <filesystem>

namespace rt {

/// Writes all that students need, and nothing that shows a solution: the references as archives of
/// their objects, built for machines of this one's kind; no known mistakes, no other right answers,
/// no tests of the project itself. A folder, or an archive if the name ends in .tar.gz; whole or
/// not at all. Returns 0. Throws InputError if it cannot, or if something is there already.
int hand_out(const std::filesystem::path& destination);

}  // namespace rt
