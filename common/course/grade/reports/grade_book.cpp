#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include <algorithm>

namespace rt::grade {

void write_grade_book(const std::filesystem::path& results, const std::vector<Mark>& marks,
                      const Term& term) {
    const std::map<int, int> stages = graded_stages(marks);
    const std::vector<StudentMarks> all = submissions(marks, term);
    const bool remarks =
        std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.remarks.empty(); });
    std::string book = cell(tr("student"));
    for (const auto& [stage, most] : stages) book += "," + name_of(stage);
    book += "," + cell(tr("total")) + "," + cell(tr("of")) +
            (remarks ? "," + cell(tr("remarks")) : "") + end_of_line;
    for (const StudentMarks& submission : all) {
        book += cell(submission.student);
        for (const auto& [stage, most] : stages)
            book += submission.stages.count(stage) == 1 ? "," + number(submission.stages.at(stage))
                                                        : "," + tr("excused");
        book += "," + number(submission.points) + "," + number(submission.of);
        if (remarks) book += "," + cell(submission.remarks);
        book += end_of_line;
    }
    write_text(results / "grades.csv", book);
}

}  // namespace rt::grade
