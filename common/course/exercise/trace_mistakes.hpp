// Known mistakes of `trace`, recognized by everything that they fail.
#pragma once

#include "common/course/build/suite_report.hpp"
#include "common/system/files.hpp"

#include <string>
#include <vector>

namespace rt {

struct TraceMistake {
    std::string name;
    std::string sentence;    ///< what a student reads
    bool is_certain = true;  ///< it fails the same questions, with the same wrong answers
};

/// The known mistake that fails the same questions with the same wrong answers; or the only two
/// that do so together, each of them some alone; or the one with the fewest others, if either fails
/// all that the other does, at least five, and few besides. The cases are all of the public suite
/// in double; the file is tests/mistakes/<stage>/trace.txt. The case of a whole picture does not
/// count.
[[nodiscard]] std::vector<TraceMistake> recognized_trace_mistakes(
    const fs::path& file, const std::vector<CaseResult>& cases);

}  // namespace rt
