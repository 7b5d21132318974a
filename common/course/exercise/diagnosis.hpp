// Known mistakes in a student's functions, by the program `diagnose`.
#pragma once

#include "common/system/files.hpp"

#include <string>
#include <vector>

namespace rt {

struct Diagnosis {
    std::vector<std::string> sentences;  ///< of known mistakes, and what answers never change
    std::vector<std::string> names;      ///< of the known mistakes
    /// The smallest call with a wrong answer, with its answers and the lines to paste, in the form
    /// of a suite's failure; empty if there is none.
    std::string smallest;
    std::string
        drawing;  ///< the path of a drawing of that call, from the project's folder; or empty
};

/// Asks the student's functions what distinguishes known mistakes: those that are recognized, or
/// the smallest call with a wrong answer. `report` is that of the stage's suite in double. Builds
/// the programs for that; the diagnosis is empty on systems without them. The functions named in
/// `unwritten` are left out.
[[nodiscard]] Diagnosis diagnosis_of(int stage, const fs::path& report,
                                     const std::vector<std::string>& unwritten);

}  // namespace rt
