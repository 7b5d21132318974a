// The variables of a student's files that outlive a call.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A global or static variable that is not constant: it has a value left by an earlier ray, and,
/// unless each thread has its own, one that another thread may overwrite.
struct StaticVariable {
    std::string name;
    std::filesystem::path file;  ///< relative to the project's folder
    int line = 0;                ///< of its declaration
    bool of_each_thread = false;
};

/// Those that a stage's objects contain, as they were last compiled, in the order of their lines.
[[nodiscard]] std::vector<StaticVariable> static_variables(int stage);

/// Those that nm lists in an object, in its System V format and with names as in the source, and
/// that this source declares and not as a constant. Constants that are computed when the program
/// starts are in the same section of an object.
[[nodiscard]] std::vector<StaticVariable> static_variables(std::string_view listed,
                                                           std::string_view source);

}  // namespace rt
