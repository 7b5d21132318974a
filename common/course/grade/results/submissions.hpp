// The marks of a class, by student and stage.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"
#include "common/stages/graded_file.hpp"

#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// One student's submission and its points.
struct StudentMarks {
    std::string student;
    std::string called;                ///< the name in reports that may be published
    std::map<int, const Mark*> marks;  ///< by stage; empty without a submission
    std::map<int, double> stages;      ///< the points of each stage, weighted; without excused ones
    double points = 0;                 ///< the total
    double of = 0;                     ///< its maximum, without excused stages; 0 if nothing counts
    double days_late = 0;
    std::string remarks;  ///< the lecturer's remarks: lines
};

/// Sorted by name, with the students of the roster without a submission. The result refers to the
/// marks, which must outlive it.
[[nodiscard]] std::vector<StudentMarks> submissions(const std::vector<Mark>& marks,
                                                    const Term& term = {});

/// The graded stages, with the maximal points of each.
[[nodiscard]] std::map<int, int> graded_stages(const std::vector<Mark>& marks);

/// The maximal weighted points of all stages, without the bonus stages, and of additions.
[[nodiscard]] double most_points(const std::map<int, int>& stages, const Term& term = {});

/// "5 triangle"
[[nodiscard]] std::string stage_title(int stage);

/// "5 triangle", "5 triangle, main.cpp"
[[nodiscard]] std::string file_title(GradedFile file);

/// "2.5 points"
[[nodiscard]] std::string points_text(double points);

/// "3", "2.5", "0.33": at most two decimals.
[[nodiscard]] std::string number(double value);

/// The same with the decimal sign of the reader's language.
[[nodiscard]] std::string number_text(double value);

}  // namespace rt::grade
