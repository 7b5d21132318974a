#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/results/submissions.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"

#include <algorithm>

namespace rt::grade {

namespace {

constexpr const char* byte_order_mark = "\xef\xbb\xbf";

/// True if a spreadsheet has written "14,50" in the columns of grades, or may be expected to.
bool has_decimal_comma(const Roster& roster) {
    for (const Csv::Row& row : roster.csv.rows)
        for (const int column : {roster.maximum, roster.grade}) {
            const std::string text = row.at(column);
            if (number_of(text) && text.find_first_of(".,") != std::string::npos)
                return text.find(',') != std::string::npos;
        }
    return roster.csv.separator == ';';
}

class Upload {
public:
    Upload(const Roster& roster, const std::vector<Mark>& marks, const Term& term)
        : roster_(roster), term_(term), comma_(has_decimal_comma(roster)) {
        for (StudentMarks& each : submissions(marks, term))
            by_student_[each.student] = std::move(each);
        int width = int(roster.csv.head.cells.size());
        // Only the columns of Canvas that identify the student: it would import the others as
        // grades.
        if (const int section = roster.csv.column({"Section"}); roster.of_canvas && section != -1)
            width = section + 1;
        for (int i = 0; i < width; ++i) columns_.push_back(i);
        if (roster.grade == -1 || roster.grade >= width) columns_.push_back(roster.grade);
        of_ = most_points(graded_stages(marks), term);
    }

    [[nodiscard]] std::string text() {
        std::string all = roster_.csv.marked ? byte_order_mark : "";
        all += line(roster_.csv.head, roster_.grade_title, "");
        for (std::size_t i = 0; i < roster_.csv.rows.size(); ++i)
            all += line(roster_.csv.rows[i], roster_.students[i]);
        return all;
    }

    [[nodiscard]] std::string summary() const {
        return "upload.csv: " + std::to_string(graded_) + " of " +
               std::to_string(roster_.csv.rows.size()) + " lines have a grade, in " +
               (roster_.grade == -1 ? "a new column \"" : "column \"") + roster_.grade_title +
               "\", " + (scaled_to_.empty() ? "not scaled" : "of " + scaled_to_);
    }

private:
    [[nodiscard]] std::string decimal(double value) const {
        std::string text = number(value);
        if (comma_) std::ranges::replace(text, '.', ',');
        return text;
    }

    /// The maximum of the grade in the upload; nothing to leave the points as they are.
    [[nodiscard]] std::optional<double> possible(const Csv::Row& row) const {
        if (term_.out_of > 0) return term_.out_of;
        return roster_.maximum_of(row);
    }

    [[nodiscard]] std::string line(const Csv::Row& row, const std::string& student) {
        if (roster_.is_maximum_row(row) && roster_.grade == -1)
            return line(row, decimal(possible(row).value_or(of_)), "");
        const auto found = by_student_.find(student);
        if (found == by_student_.end()) return line(row, row.at(roster_.grade), "");
        const StudentMarks& marks = found->second;
        const std::string remarks = no_formula(readable(marks.remarks));
        if (marks.of <= 0) return line(row, row.at(roster_.grade), remarks);  // nothing counts
        ++graded_;
        const std::optional<double> most = possible(row);
        // All are of the same maximum, though not all stages count for everybody. Points above
        // that, by a bonus or an addition, are worth the same for everybody.
        const double above = std::max(0.0, marks.points - marks.of);
        const double share = (marks.points - above) / marks.of + above / of_;
        double points = share * most.value_or(of_);
        // Moodle accepts no grade above its maximum, for example with a bonus.
        if (most && roster_.maximum != -1) points = std::min(points, *most);
        if (most) scaled_to_ = decimal(*most);
        return line(row, decimal(points), remarks);
    }

    [[nodiscard]] std::string line(const Csv::Row& row, const std::string& grade,
                                   const std::string& remarks) const {
        const char separator = roster_.csv.separator;
        std::string cells;
        for (const int column : columns_) {
            std::string value = row.at(column);
            if (column == roster_.grade) value = grade;
            if (column == roster_.comment && column != -1 && !remarks.empty()) value = remarks;
            cells += plain_cell(value, separator) + separator;
        }
        cells.pop_back();
        return cells + end_of_line;
    }

    const Roster& roster_;
    const Term& term_;
    std::map<std::string, StudentMarks> by_student_;
    std::vector<int> columns_;  ///< of the roster; -1 for a new one with the grade
    bool comma_ = false;
    double of_ = 0;
    std::size_t graded_ = 0;
    std::string scaled_to_;
};

void write_names(const fs::path& results, const std::vector<Mark>& marks, const Term& term) {
    std::string names = std::string("called,student") + end_of_line;
    for (const StudentMarks& each : submissions(marks, term))
        names += each.called + "," + cell(each.student) + end_of_line;
    write_text(results / "names.csv", names);
}

}  // namespace

std::string write_upload(const fs::path& results, const std::vector<Mark>& marks,
                         const Term& term) {
    std::error_code none;
    if (term.anonymous)
        write_names(results, marks, term);
    else
        fs::remove(results / "names.csv", none);
    if (!term.roster) {
        fs::remove(results / "upload.csv", none);
        return "";
    }
    Upload upload(*term.roster, marks, term);
    write_text(results / "upload.csv", upload.text());
    return upload.summary();
}

}  // namespace rt::grade
