// The files of a hand-out.
#pragma once

#include <string>

namespace rt {

/// True if students get the file at this path of the project. Whatever is not named in the list of
/// rooms and folders stays out.
[[nodiscard]] bool is_for_students(const std::string& path);

}  // namespace rt
