// Who handed in what somebody else did.
#pragma once

#include "common/course/grade/results.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// Students who handed in the same file.
struct SameFile {
    int stage = 1;
    std::vector<std::string> students;
};

/// Two students whose files are near, if not the same.
struct NearFiles {
    std::string one;
    std::string other;
    std::map<int, int> percent;  ///< by stage: how much of the shorter file is in the longer
};

struct Likeness {
    std::vector<SameFile> same;   ///< by stage
    std::vector<NearFiles> near;  ///< most stages first
};

/// From here on, files are near. Right answers that were written apart, the references and those in
/// tests/alternatives, have 31 percent in common at most; a file that is renamed and edited here
/// and there keeps more.
inline constexpr int near_percent = 60;

/// Compares the files in results/students/<student>/submitted/, stage by stage. What stands in the
/// project's starter does not count, and what many students have counts little. Nothing is said of
/// a file that is too short to tell.
[[nodiscard]] Likeness likeness(const std::filesystem::path& results,
                                const std::filesystem::path& project,
                                const std::vector<Mark>& marks);

}  // namespace rt::grade
