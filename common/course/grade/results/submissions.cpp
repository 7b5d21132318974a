#include "common/course/grade/results/submissions.hpp"

#include "common/stages/stages.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <set>

namespace rt::grade {

namespace {

void add_remark(StudentMarks& submission, const std::string& words) {
    submission.remarks += (submission.remarks.empty() ? "" : "\n") + words;
}

const PointsByHand* override_of(const StudentMarks& submission, int stage, const Term& term) {
    const auto found = term.overrides.find({submission.student, stage});
    return found == term.overrides.end() ? nullptr : &found->second;
}

std::string reason(const PointsByHand& given) {
    return given.comment.empty() ? "" : tr(": ") + given.comment;
}

/// The reasons why stages have no file, such as an archive that cannot be opened, each once.
std::set<std::string> why_missing(const StudentMarks& submission) {
    std::set<std::string> reasons;
    for (const auto& [stage, mark] : submission.marks)
        if (mark->verdict == Verdict::missing && !mark->words.empty())
            reasons.insert(mark->words.substr(0, mark->words.find('\n')));
    return reasons;
}

/// Adds the points of the stages, without those from which the student is excused.
void count_stages(StudentMarks& submission, const std::map<int, int>& graded, const Term& term) {
    std::map<int, int> counted = graded;
    for (const auto& [stage, most] : graded) {
        const auto mark = submission.marks.find(stage);
        double points = mark == submission.marks.end() ? 0 : mark->second->points();
        const PointsByHand* given = override_of(submission, stage, term);
        if (given != nullptr && given->excused) {
            add_remark(submission,
                       tr("{stage}: excused", {{"stage", stage_title(stage)}}) + reason(*given));
            counted.erase(stage);
            continue;
        }
        if (given != nullptr) {
            add_remark(submission, tr("{stage}: {points} instead of {before}",
                                      {{"stage", stage_title(stage)},
                                       {"points", number_text(given->points)},
                                       {"before", number_text(points)}}) +
                                       reason(*given));
            points = given->points;
        }
        submission.stages[stage] = points * term.weight(stage);
        submission.points += submission.stages[stage];
    }
    const bool has_additions = term.additions.count(submission.student) == 1;
    if (!counted.empty() || has_additions) submission.of = most_points(counted, term);
}

/// Computes the points of the marks in this term.
void count(StudentMarks& submission, const std::map<int, int>& graded, const Term& term) {
    count_stages(submission, graded, term);
    const auto late = term.days_late.find(submission.student);
    submission.days_late = late == term.days_late.end() ? 0 : late->second;
    if (const double lost = std::min(100.0, term.late_percent * submission.days_late); lost > 0) {
        add_remark(submission, tr("{days} days late: {percent} % of {points} points",
                                  {{"days", number_text(submission.days_late)},
                                   {"percent", number_text(lost)},
                                   {"points", number_text(submission.points)}}));
        submission.points *= 1 - lost / 100;
    }
    if (const auto more = term.additions.find(submission.student); more != term.additions.end())
        for (const PointsByHand& given : more->second) {
            add_remark(submission,
                       tr("in addition: {points}", {{"points", number_text(given.points)}}) +
                           reason(given));
            submission.points += given.points;
        }
    submission.points = std::max(submission.points, 0.0);
    if (const PointsByHand* given = override_of(submission, Term::total, term)) {
        add_remark(submission, tr("in all: {points} instead of {before}",
                                  {{"points", number_text(given->points)},
                                   {"before", number_text(submission.points)}}) +
                                   reason(*given));
        submission.points = given->points;
    }
}

/// Adds the students on the roster who have submitted nothing, or with a group.
void add_roster(std::map<std::string, StudentMarks>& by_name, const Term& term) {
    if (!term.roster) return;
    for (const std::string& student : term.roster->students)
        if (!student.empty()) by_name[student];
    for (const auto& [student, shared] : term.shared) {
        StudentMarks& submission = by_name[student];
        submission.marks = by_name[shared.student].marks;
        add_remark(submission,
                   tr("the submission of {student}, group \"{group}\"",
                      {{"student", term.called(shared.student)}, {"group", shared.group}}));
    }
    for (const std::string& group : term.groups) by_name.erase(group);
}

}  // namespace

std::vector<StudentMarks> submissions(const std::vector<Mark>& marks, const Term& term) {
    std::map<std::string, StudentMarks> by_name;
    for (const Mark& mark : marks) by_name[mark.student].marks[mark.stage] = &mark;
    add_roster(by_name, term);
    const std::map<int, int> graded = graded_stages(marks);
    std::vector<StudentMarks> all;
    for (auto& [name, submission] : by_name) {
        submission.student = name;
        submission.called = term.called(name);
        if (submission.marks.empty()) add_remark(submission, tr("submitted nothing"));
        for (const std::string& reason : why_missing(submission))
            add_remark(submission, tr_text(reason));
        for (const auto& [stage, mark] : submission.marks)
            if (mark->verdict == Verdict::postponed)
                add_remark(submission, stage_title(stage) + tr(": ") + tr("not graded yet"));
        count(submission, graded, term);
        all.push_back(std::move(submission));
    }
    return all;
}

std::map<int, int> graded_stages(const std::vector<Mark>& marks) {
    std::map<int, int> stages;
    for (const Mark& mark : marks) {
        int& most = stages[mark.stage];
        most = std::max(most, mark.most);
    }
    return stages;
}

double most_points(const std::map<int, int>& stages, const Term& term) {
    double sum = term.additions_of;
    for (const auto& [stage, most] : stages)
        if (term.bonus.count(stage) == 0) sum += most * term.weight(stage);
    return sum;
}

std::string stage_title(int stage) {
    std::string title = topic_of(stage);
    std::ranges::replace(title, '_', ' ');
    return std::to_string(stage) + " " + tr(title);
}

std::string file_title(GradedFile file) {
    return stage_title(file.stage) + (file.is_trace ? ", " + file_name(file) : "");
}

std::string points_text(double points) {
    return tr(points == 1 ? "{number} point" : "{number} points",
              {{"number", number_text(points)}});
}

std::string number(double value) {
    std::string digits = formatted("%.2f", value);
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
    return digits == "-0" ? "0" : digits;
}

std::string number_text(double value) {
    std::string digits = number(value);
    const std::string decimal_sign = tr("0.25 points").substr(1, 1);
    if (const std::size_t point = digits.find('.'); point != std::string::npos)
        digits.replace(point, 1, decimal_sign);
    return digits;
}

}  // namespace rt::grade
