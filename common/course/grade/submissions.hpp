// Marks as a class has them: by student, by stage.
#pragma once

#include "common/course/grade/results.hpp"
#include "common/course/grade/term.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// What one student handed in, and what it is worth.
struct Submission {
    std::string student;
    std::string called;                ///< in what may be shown
    std::map<int, const Mark*> marks;  ///< by stage; none if nothing was handed in
    std::map<int, double> stages;      ///< the points of each, weighted, as they count
    double points = 0;                 ///< in all
    double days_late = 0;
    std::string remarks;  ///< on what is not the grader's: lines
};

/// By name, and those on the roster who handed in nothing. They last as long as the marks.
[[nodiscard]] std::vector<Submission> submissions(const std::vector<Mark>& marks,
                                                  const Term& term = {});

/// The stages that are graded, and the points that each is worth.
[[nodiscard]] std::map<int, int> graded_stages(const std::vector<Mark>& marks);

/// The points that all stages are worth, weighted, without those that are a bonus.
[[nodiscard]] double most_points(const std::map<int, int>& stages, const Term& term = {});

/// "5 triangle"
[[nodiscard]] std::string stage_title(int stage);

/// "3", "2.5", "0.33": no more than two decimals.
[[nodiscard]] std::string number(double value);

}  // namespace rt::grade
