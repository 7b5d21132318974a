#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/reports/html.hpp"
#include "common/course/grade/results/likeness.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/course/grade/results/winnowing.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <utility>

namespace rt::grade {

namespace {

std::string section(const std::string& title, const std::string& inside) {
    return "<section>\n<h2>" + title + "</h2>\n" + inside + "</section>\n";
}

std::string soft_cell(const std::string& title, const std::string& sign) {
    return "<td class=\"soft\" title=\"" + title + "\">" + sign + "</td>";
}

std::string missing_cell() {
    return soft_cell(tr("not submitted"), "–");
}

std::string text_head(const std::string& title) {
    return "<th class=\"text\">" + title + "</th>";
}

std::string points_cell(int points, int most) {
    return share_cell("share", points, most, std::to_string(100 * points / std::max(most, 1)));
}

std::string mark_cell(const Mark& mark, int most) {
    if (mark.verdict == Verdict::missing) return missing_cell();
    if (mark.verdict == Verdict::refused)
        return "<td class=\"share\" style=\"--share: 0%\" title=\"" + tr("cannot be graded") +
               "\">×</td>";
    if (mark.verdict == Verdict::postponed) return soft_cell(tr("not graded yet"), "?");
    return points_cell(mark.points(), most);
}

/// Links to the student's feedback, unless the name is hidden or there is no feedback.
std::string student_cell(const StudentMarks& submission) {
    const bool linked = submission.called == submission.student && !submission.marks.empty();
    return "<th class=\"student\">" +
           (linked ? "<a href=\"students/" + percent_encoded(submission.student) +
                         "/feedback.html\">" + escaped(submission.student) + "</a>"
                   : escaped(submission.called)) +
           "</th>";
}

/// The mean result of the submitted stages.
std::string mean_row(const std::vector<Mark>& marks, const std::map<int, int>& stages) {
    std::string cells = "<th class=\"student\">" + tr("mean of submissions") + "</th>";
    for (const auto& [stage, most] : stages) {
        int points = 0;
        int most_of_all = 0;
        for (const Mark& mark : marks)
            if (mark.stage == stage && mark.verdict != Verdict::missing &&
                mark.verdict != Verdict::postponed) {
                points += mark.points();
                most_of_all += most;
            }
        cells += most_of_all == 0 ? missing_cell() : points_cell(points, most_of_all);
    }
    return row(cells + "<td></td>");
}

/// A lecturer's points take the place of the grader's.
std::string stage_cell(const StudentMarks& submission, int stage, int most, const Term& term) {
    if (submission.stages.count(stage) == 0) return soft_cell(tr("excused"), tr("e"));
    if (const auto given = term.overrides.find({submission.student, stage});
        given != term.overrides.end())
        return points_cell(int(given->second.points), most);
    const auto mark = submission.marks.find(stage);
    return mark == submission.marks.end() ? missing_cell() : mark_cell(*mark->second, most);
}

std::string matrix(const std::vector<Mark>& marks, const std::map<int, int>& stages,
                   const Term& term) {
    std::string head = "<th class=\"student\"></th>";
    for (const auto& [stage, most] : stages)
        head += "<th class=\"stage\"><span>" + stage_title(stage) +
                (term.bonus.count(stage) == 1 ? ", " + tr("bonus") : "") + "</span></th>";
    std::string rows = row(head + "<th>" + tr("points") + "</th>");
    for (const StudentMarks& submission : submissions(marks, term)) {
        std::string cells = student_cell(submission);
        for (const auto& [stage, most] : stages) cells += stage_cell(submission, stage, most, term);
        const int share =
            std::clamp(int(100 * submission.points / std::max(submission.of, 1e-9)), 0, 100);
        rows += row(cells + share_cell("share", share, 100, number_text(submission.points)));
    }
    return "<p class=\"soft\">" +
           tr("The points of each stage, of a hundred; – means not submitted, e excused, × cannot "
              "be judged, ? not judged yet.") +
           "</p>\n" + table("matrix", rows + mean_row(marks, stages));
}

/// The changes by the lecturer's settings, and the students without a submission.
std::string remarks(const std::vector<Mark>& marks, const Term& term) {
    std::string rows;
    for (const StudentMarks& submission : submissions(marks, term))
        for (const std::string& line : lines_of(submission.remarks))
            rows += row(text_cell(submission.called) + text_cell(line));
    return rows.empty() ? "" : section(tr("Remarks"), table("list", rows));
}

/// The files that belong to no submission, and the lines of the term's files that fit nothing.
std::string left_over(const fs::path& results, const Term& term) {
    std::vector<std::string> lines = lines_in(results / left_over_file);
    lines.insert(lines.end(), term.notes.begin(), term.notes.end());
    if (lines.empty()) return "";
    if (term.anonymous)
        return section(
            tr("Left over"),
            "<p>" +
                tr("{lines} with names: left_over.txt has those on files, and <code>./course "
                   "grade --report</code> prints those on term.txt.",
                   {{"lines", counted(int(lines.size()), "line")}}) +
                "</p>\n");
    std::string rows;
    for (const std::string& line : lines) rows += row(text_cell(tr_text(line)));
    return section(tr("Left over"), table("list", rows));
}

std::string first_line(const std::string& words) {
    return words.substr(0, words.find('\n'));
}

/// The sentences on a worker that ended before it answered, or on cases that the suite did not
/// reach, with the number of cases of each.
std::map<std::string, int> endings(const Mark& mark) {
    std::map<std::string, int> counts;
    for (const CaseMark& each : mark.cases)
        for (const char* sentence : {no_answer_start, not_reached})
            if (const std::size_t start = each.words.find(sentence); start != std::string::npos)
                ++counts[first_line(each.words.substr(start))];
    return counts;
}

std::string subsection(const std::string& title, const std::vector<std::string>& rows) {
    return "<h3>" + title + "</h3>\n" + first_rows("", rows);
}

/// The students whose code tried a forbidden operation, ended otherwise, or was not run.
std::string stopped(const std::vector<Mark>& marks, const Term& term) {
    std::vector<std::string> tried;
    std::vector<std::string> ended;
    std::vector<std::string> refused;
    std::vector<std::string> postponed;
    for (const Mark& mark : marks) {
        const std::string who =
            text_cell(term.called(mark.student)) + text_cell(stage_title(mark.stage));
        for (const auto& [sentence, cases] : endings(mark)) {
            const std::string where = tr("in {cases}", {{"cases", counted(cases, "case")}});
            if (sentence.find(forbidden_operation) != std::string::npos)
                tried.push_back(row(who + text_cell(where)));
            else
                ended.push_back(row(who + text_cell(where) + text_cell(tr_text(sentence))));
        }
        if (mark.verdict == Verdict::refused)
            refused.push_back(row(who + text_cell(tr_text(first_line(mark.words)))));
        if (mark.verdict == Verdict::postponed) postponed.push_back(row(who));
    }
    std::string html;
    if (!postponed.empty())
        html += subsection(tr("Not judged yet, through no fault of theirs: the same "
                              "<code>grade</code> command judges them"),
                           postponed);
    if (!tried.empty())
        html += subsection(tr("Forbidden operations: files, processes, networks"), tried);
    if (!ended.empty()) html += subsection(tr("Crashes, and limits of time"), ended);
    if (!refused.empty()) html += subsection(tr("Could not be graded"), refused);
    return html.empty() ? "<p>" + tr("Nobody's.") + "</p>\n" : html;
}

std::string mistakes(const std::vector<Mark>& marks) {
    std::map<std::pair<int, std::string>, int> counts;
    std::map<int, int> judged;
    for (const Mark& mark : marks) {
        if (mark.verdict == Verdict::judged) ++judged[mark.stage];
        for (const std::string& sentence : lines_of(mark.mistake)) ++counts[{mark.stage, sentence}];
    }
    if (counts.empty()) return "<p>" + tr("No known mistake was recognized.") + "</p>\n";
    std::vector<std::pair<std::pair<int, std::string>, int>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(sorted, std::greater(), [](const auto& each) { return each.second; });
    std::vector<std::string> rows;
    for (const auto& [which, count] : sorted)
        rows.push_back(row(share_cell("bar", count, judged[which.first], std::to_string(count)) +
                           text_cell(stage_title(which.first)) + text_cell(tr_text(which.second))));
    return first_rows(row("<th>" + tr("students") + "</th>" + text_head(tr("stage")) +
                          text_head(tr("message to the student"))),
                      rows);
}

struct CaseCount {
    int stage = 1;
    std::string name;
    int passed = 0;
    int judged = 0;
};

/// The smallest share that passes first.
std::vector<CaseCount> hardest_cases(const std::vector<Mark>& marks) {
    std::map<std::pair<int, std::string>, CaseCount> counts;
    for (const Mark& mark : marks)
        for (const CaseMark& each : mark.cases) {
            CaseCount& count = counts[{mark.stage, each.name}];
            count.stage = mark.stage;
            count.name = each.name;
            count.passed += each.passed ? 1 : 0;
            ++count.judged;
        }
    std::vector<CaseCount> all;
    for (auto& [key, count] : counts)
        if (count.passed < count.judged) all.push_back(std::move(count));
    std::ranges::stable_sort(all, [](const CaseCount& one, const CaseCount& other) {
        return one.passed * other.judged < other.passed * one.judged;
    });
    return all;
}

std::string cases(const std::vector<Mark>& marks) {
    std::vector<std::string> rows;
    for (const CaseCount& each : hardest_cases(marks))
        rows.push_back(
            row(share_cell("bar", each.passed, each.judged, percent(each.passed, each.judged)) +
                "<td>" + std::to_string(each.judged) + "</td>" +
                text_cell(stage_title(each.stage)) + text_cell(tr(each.name))));
    if (rows.empty()) return "<p>" + tr("No case fails.") + "</p>\n";
    return "<p class=\"soft\">" + tr("Only files that could be graded are counted.") + "</p>\n" +
           first_rows(row("<th>" + tr("pass") + "</th><th>" + tr("judged") + "</th>" +
                          text_head(tr("stage")) + text_head(tr("case"))),
                      rows);
}

std::string names(const std::vector<std::string>& students, const Term& term) {
    return joined(students, [&](const std::string& student) { return term.called(student); });
}

std::string near_stages(const NearGroup& group) {
    return joined(group.percent, [](const auto& stage) {
        const auto [least, most] = stage.second;
        return file_title(stage.first) + " " + (least == most ? "" : std::to_string(least) + "–") +
               std::to_string(most) + " %";
    });
}

std::string same(const std::vector<SameFile>& found, const Term& term) {
    std::string rows;
    for (const SameFile& each : found)
        rows += row(text_cell(file_title(each.file)) + text_cell(names(each.students, term)));
    return rows.empty() ? "" : "<h3>" + tr("The same file") + "</h3>\n" + table("list", rows);
}

std::string near(const std::vector<NearFiles>& found, const Term& term) {
    if (found.empty()) return "";
    std::vector<std::string> rows;
    for (const NearGroup& each : groups(found))
        rows.push_back(row(text_cell(names({each.students.begin(), each.students.end()}, term)) +
                           text_cell(near_stages(each))));
    return "<h3>" + tr("Similar files") + "</h3>\n<p class=\"soft\">" +
           tr("The percentage of the shorter file that is in the longer, from {percent} % on, "
              "apart "
              "from names and comments. In a group, each student's file is similar to another's. "
              "Passages of the starter do not count; passages of many students count little.",
              {{"percent", near_percent}}) +
           "</p>\n" + first_rows("", rows);
}

/// Copies of the project's main.cpp that were changed a little.
std::string copies(const std::vector<Mark>& marks, const std::vector<LikeMain>& like,
                   const Term& term) {
    std::string rows;
    const auto add = [&](const std::string& student, int stage, const std::string& percent) {
        rows += row(text_cell(term.called(student)) + text_cell(file_title({stage, true})) +
                    text_cell(percent));
    };
    for (const Mark& mark : marks)
        if (mark.words.find(copied_main) != std::string::npos)
            add(mark.student, mark.stage, tr("not graded"));
    for (const LikeMain& each : like)
        add(each.student, each.stage, std::to_string(each.percent) + " %");
    return rows.empty()
               ? ""
               : "<h3>" + tr("Copies of the project's main.cpp") + "</h3>\n<p class=\"soft\">" +
                     tr("A copy that differs from it by comments, names or layout is not "
                        "graded. Of the others, which are graded, the percentage of the "
                        "longer file that is in both, from {percent} % on.",
                        {{"percent", like_main_percent}}) +
                     "</p>\n" + table("list", rows);
}

std::string alike(const Similarity& found, const Term& term) {
    const std::string html =
        "<p class=\"hint\">" +
        tr("Similarity is no proof. Students who worked together, or from the same page, write "
           "similar code, and a short stage leaves little choice: read the files, and ask, before "
           "you conclude anything.") +
        "</p>\n";
    if (found.same.empty() && found.near.empty())
        return html + "<p>" + tr("No two files are similar.") + "</p>\n";
    return html + same(found.same, term) + near(found.near, term);
}

}  // namespace

void write_class_report(const fs::path& results, const fs::path& project,
                        const std::vector<Mark>& marks, const Term& term,
                        const std::string& edition) {
    const std::map<int, int> stages = graded_stages(marks);
    const double most = most_points(stages, term);
    const Similarity found = similarity(results, project, marks);
    const std::string body =
        "<header><h1>" + tr("Class report") + "</h1> <p>" +
        counted(int(submissions(marks, term).size()), "student") + ", " +
        counted(int(stages.size()), "stage") + ", " + points_text(most) + "</p></header>\n" +
        (edition.empty() ? "" : "<p class=\"soft\">" + escaped(edition) + "</p>\n") +
        section(tr("Points"), matrix(marks, stages, term)) + remarks(marks, term) +
        left_over(results, term) + section(tr("Known mistakes"), mistakes(marks)) +
        section(tr("Hardest cases"), cases(marks)) +
        section(tr("Code that was stopped or refused"), stopped(marks, term)) +
        section(tr("Similar files"), copies(marks, found.like_main, term) + alike(found, term));
    write_text(results / "class.html", page(tr("Class report"), body));
}

}  // namespace rt::grade
