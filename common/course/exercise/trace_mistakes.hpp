// Known mistakes of `trace`, recognized by everything that they fail.
#pragma once

#include "common/course/build/suite_report.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

struct TraceMistake {
    std::string name;
    std::string sentence;  ///< what a student reads
};

/// The known mistake that fails the same cases, in each of them on the same scenes and with the
/// same wrong colors. The cases are all of the public suite in double; the file is
/// tests/mistakes/<stage>/trace.txt. The case of a whole picture does not count.
[[nodiscard]] std::optional<TraceMistake> recognized_trace_mistake(
    const std::filesystem::path& file, const std::vector<CaseResult>& cases);

}  // namespace rt
