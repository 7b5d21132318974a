// Symbols that a student's object defines or calls without permission.
#pragma once

#include "common/course/grade/judging/object_file.hpp"

#include <set>
#include <string>

namespace rt::grade {

/// The functions of all contracts, and of common/, by their linker names: seats/graded/*.txt.
struct StageFunctions {
    std::set<std::string> own;       ///< the stage's functions, which the student writes
    std::set<std::string> callable;  ///< other functions that the student may call
    std::set<std::string> others;    ///< those of the other stages
};

/// A sentence on the first such symbol; empty if there is none. It is an explanation, not a
/// defense: functions that are not callable are missing when the worker is linked, and the sandbox
/// stops the rest.
[[nodiscard]] std::string foreign_symbol(const ObjectFile& object, const StageFunctions& functions);

}  // namespace rt::grade
