// The classes that a folder of results is about: places, and the students who were there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

/// True if an earlier run has graded the student at this place, or if no run has had a class.
[[nodiscard]] bool is_graded_at(const std::filesystem::path& results,
                                const std::filesystem::path& place, const std::string& student);

/// Adds the students of a place to results/.classes. The place is a hash: results contain no names
/// of the machine's folders. Throws InputError.
void add_graded_class(const std::filesystem::path& results, const std::filesystem::path& place,
                      const std::vector<std::string>& students);

}  // namespace rt::grade
