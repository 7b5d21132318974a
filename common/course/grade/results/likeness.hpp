// Similar submissions of different students.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/stages/graded_file.hpp"
#include "common/system/files.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rt::grade {

struct SameFile {
    GradedFile file;
    std::vector<std::string> students;
};

/// Two students with similar files.
struct NearFiles {
    std::string one;
    std::string other;
    std::map<GradedFile, int> percent;  ///< the percentage of the shorter file that the longer one
                                        ///< contains
};

/// Students of whom each is near another one.
struct NearGroup {
    std::set<std::string> students;
    std::map<GradedFile, std::pair<int, int>> percent;  ///< the least and the most of the pairs
};

/// The groups that the pairs connect, in the order of their first pairs.
[[nodiscard]] std::vector<NearGroup> groups(const std::vector<NearFiles>& near);

/// A main.cpp that is like the project's own (winnowing.hpp).
struct LikeMain {
    std::string student;
    int stage = 1;
    int percent = 0;
};

struct Similarity {
    std::vector<SameFile> same;   ///< by stage
    std::vector<NearFiles> near;  ///< most files first
    std::vector<LikeMain> like_main;
};

/// The threshold of similarity. Independent right answers (the references and those in
/// tests/alternatives) share at most 31 percent; a file that is renamed and slightly edited shares
/// more than this threshold.
inline constexpr int near_percent = 60;

/// Compares the files in results/students/<student>/submitted/, stage by stage. Passages of the
/// project's starter, and of its main.cpp, do not count, and passages of many students count
/// little. Files that are too short to compare are not reported.
[[nodiscard]] Similarity similarity(const fs::path& results, const fs::path& project,
                                    const std::vector<Mark>& marks);

}  // namespace rt::grade
