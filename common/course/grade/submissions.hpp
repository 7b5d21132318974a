// Marks as a class has them: by student, by stage.
#pragma once

#include "common/course/grade/results.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// What one student handed in.
struct Submission {
    std::string student;
    std::map<int, const Mark*> marks;  ///< by stage

    [[nodiscard]] int points() const;
};

/// By name. They last as long as the marks.
[[nodiscard]] std::vector<Submission> submissions(const std::vector<Mark>& marks);

/// The stages that are graded, and the points that each is worth.
[[nodiscard]] std::map<int, int> graded_stages(const std::vector<Mark>& marks);

/// The points that all stages are worth.
[[nodiscard]] int most_points(const std::map<int, int>& stages);

/// "5 triangle"
[[nodiscard]] std::string stage_title(int stage);

}  // namespace rt::grade
