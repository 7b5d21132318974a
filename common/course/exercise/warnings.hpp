// Warnings about files that pass the suite, and yet cannot be graded or linked as they are.
#pragma once

#include "common/course/exercise/workbook.hpp"

#include <string>

namespace rt {

/// The compiler's first warning, variables that outlive a call, and what will be missing or
/// refused: a symbol that another stage defines too, an #include that a graded file may not have, a
/// file that is not graded. Each ends its line.
[[nodiscard]] std::string warnings_of(const Workbook& workbook);

}  // namespace rt
