// The variables of a student's files that outlive a call.
#pragma once

#include "common/course/build/student_objects.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A global or static variable that is not constant: it has a value left by an earlier ray, and,
/// unless each thread has its own, one that another thread may overwrite.
struct StaticVariable {
    std::string name;
    fs::path file;  ///< relative to the project's folder
    int line = 0;   ///< of its declaration
    bool of_each_thread = false;
};

/// Those of these files that are of the stage, in the order of their lines.
[[nodiscard]] std::vector<StaticVariable> static_variables(int stage,
                                                           const std::vector<CompiledFile>& files);

/// Those that an object has among its symbols, and that its source declares and not as a constant.
/// Constants that are computed when the program starts are in the same section of an object.
[[nodiscard]] std::vector<StaticVariable> static_variables(const std::vector<Symbol>& symbols,
                                                           std::string_view source);

}  // namespace rt
