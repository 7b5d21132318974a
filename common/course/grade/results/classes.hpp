// The places of the classes that a folder of results is about.
#pragma once

#include <filesystem>

namespace rt::grade {

/// True if the place is a class of an earlier run, or if no run has had a class.
[[nodiscard]] bool is_graded_class(const std::filesystem::path& results,
                                   const std::filesystem::path& place);

/// Adds the place to results/.classes, as a hash: results contain no names of the machine's
/// folders. Throws InputError.
void add_graded_class(const std::filesystem::path& results, const std::filesystem::path& place);

}  // namespace rt::grade
