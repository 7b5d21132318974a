// What a student's object defines and calls that is not his to define, or to call.
#pragma once

#include "common/course/grade/object_file.hpp"

#include <set>
#include <string>

namespace rt::grade {

/// The functions of all contracts, and of common/, as the linker names them: seats/graded/*.txt.
struct StageFunctions {
    std::set<std::string> own;       ///< the stage's, which the student writes
    std::set<std::string> callable;  ///< by him, besides
    std::set<std::string> others;    ///< of the other stages
};

/// A sentence on the first of such symbols; nothing if there is none. It explains, and keeps nobody
/// out: what is not callable is not there when his worker is linked, and the rest is the seal's.
[[nodiscard]] std::string foreign_symbol(const ObjectFile& object, const StageFunctions& functions);

}  // namespace rt::grade
