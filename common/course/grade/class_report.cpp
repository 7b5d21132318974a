#include "common/course/grade/class_report.hpp"

#include "common/course/files.hpp"
#include "common/course/grade/html.hpp"
#include "common/course/grade/html_table.hpp"
#include "common/course/grade/likeness.hpp"
#include "common/course/grade/submissions.hpp"

#include <algorithm>
#include <utility>

namespace rt::grade {

namespace {

std::string section(const std::string& title, const std::string& inside) {
    return "<section>\n<h2>" + title + "</h2>\n" + inside + "</section>\n";
}

constexpr const char* missing_cell = "<td class=\"soft\" title=\"not handed in\">–</td>";
constexpr const char* refused_cell =
    "<td class=\"share\" style=\"--share: 0%\" title=\"cannot be judged\">×</td>";

std::string points_cell(int points, int most) {
    return share_cell("share", points, most, std::to_string(100 * points / std::max(most, 1)));
}

std::string mark_cell(const Mark& mark, int most) {
    if (mark.verdict == Verdict::missing) return missing_cell;
    if (mark.verdict == Verdict::refused) return refused_cell;
    return points_cell(mark.points(), most);
}

std::string student_cell(const std::string& student) {
    return "<th class=\"student\"><a href=\"students/" + address(student) + "/feedback.html\">" +
           escaped(student) + "</a></th>";
}

/// The mean share of what was handed in.
std::string mean_row(const std::vector<Mark>& marks, const std::map<int, int>& stages) {
    std::string cells = "<th class=\"student\">mean, handed in</th>";
    for (const auto& [stage, most] : stages) {
        int points = 0;
        int most_of_all = 0;
        for (const Mark& mark : marks)
            if (mark.stage == stage && mark.verdict != Verdict::missing) {
                points += mark.points();
                most_of_all += most;
            }
        cells += most_of_all == 0 ? missing_cell : points_cell(points, most_of_all);
    }
    return row(cells + "<td></td>");
}

std::string matrix(const std::vector<Mark>& marks, const std::map<int, int>& stages) {
    std::string head = "<th class=\"student\"></th>";
    for (const auto& [stage, most] : stages)
        head += "<th title=\"" + stage_title(stage) + "\">" + std::to_string(stage) + "</th>";
    std::string rows = row(head + "<th>points</th>");
    for (const Submission& submission : submissions(marks)) {
        std::string cells = student_cell(submission.student);
        for (const auto& [stage, most] : stages) {
            const auto mark = submission.marks.find(stage);
            cells += mark == submission.marks.end() ? missing_cell : mark_cell(*mark->second, most);
        }
        const int points = submission.points();
        rows +=
            row(cells + share_cell("share", points, most_points(stages), std::to_string(points)));
    }
    return "<p class=\"soft\">The points of each stage, of a hundred; – is not handed in, × cannot "
           "be judged.</p>\n" +
           table("matrix", rows + mean_row(marks, stages));
}

std::string mistakes(const std::vector<Mark>& marks) {
    std::map<std::pair<int, std::string>, int> counts;
    std::map<int, int> judged;
    for (const Mark& mark : marks) {
        if (mark.verdict == Verdict::judged) ++judged[mark.stage];
        for (const std::string& sentence : lines_of(mark.mistake)) ++counts[{mark.stage, sentence}];
    }
    if (counts.empty()) return "<p>None was recognised.</p>\n";
    std::vector<std::pair<std::pair<int, std::string>, int>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& one, const auto& other) { return one.second > other.second; });
    std::vector<std::string> rows;
    for (const auto& [which, count] : sorted)
        rows.push_back(row(share_cell("bar", count, judged[which.first], std::to_string(count)) +
                           text_cell(stage_title(which.first)) + text_cell(which.second)));
    return first_rows(row("<th>students</th><th class=\"text\">stage</th>"
                          "<th class=\"text\">what a student is told</th>"),
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
    std::stable_sort(all.begin(), all.end(), [](const CaseCount& one, const CaseCount& other) {
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
                text_cell(stage_title(each.stage)) + text_cell(each.name)));
    if (rows.empty()) return "<p>No case fails.</p>\n";
    return "<p class=\"soft\">Of the files that could be judged.</p>\n" +
           first_rows(row("<th>pass</th><th>of</th><th class=\"text\">stage</th>"
                          "<th class=\"text\">case</th>"),
                      rows);
}

std::string names(const std::vector<std::string>& students) {
    std::string all;
    for (const std::string& student : students) all += (all.empty() ? "" : ", ") + student;
    return all;
}

std::string near_stages(const NearFiles& near) {
    std::string all;
    for (const auto& [stage, percent] : near.percent)
        all +=
            (all.empty() ? "" : ", ") + stage_title(stage) + " " + std::to_string(percent) + " %";
    return all;
}

std::string same(const std::vector<SameFile>& found) {
    std::string rows;
    for (const SameFile& each : found)
        rows += row(text_cell(stage_title(each.stage)) + text_cell(names(each.students)));
    return rows.empty() ? "" : "<h3>The same file</h3>\n" + table("list", rows);
}

std::string near(const std::vector<NearFiles>& found) {
    if (found.empty()) return "";
    std::vector<std::string> rows;
    for (const NearFiles& each : found)
        rows.push_back(
            row(text_cell(names({each.one, each.other})) + text_cell(near_stages(each))));
    return "<h3>Near, but not the same</h3>\n<p class=\"soft\">How much of the shorter file is in "
           "the longer, from " +
           std::to_string(near_percent) +
           " % on, whatever the names and comments. What the starter has does not count; what many "
           "have counts little.</p>\n" +
           first_rows("", rows);
}

std::string alike(const Likeness& found) {
    const std::string html =
        "<p class=\"hint\">Likeness is no proof. Two who worked side by side, or from the same "
        "page, write alike, and a short stage leaves little choice: read the files, and ask, "
        "before you conclude anything.</p>\n";
    if (found.same.empty() && found.near.empty()) return html + "<p>No two files are alike.</p>\n";
    return html + same(found.same) + near(found.near);
}

}  // namespace

void write_class_report(const std::filesystem::path& results, const std::filesystem::path& project,
                        const std::vector<Mark>& marks) {
    const std::map<int, int> stages = graded_stages(marks);
    const std::string body =
        "<header><h1>Class report</h1> <p>" + counted(int(submissions(marks).size()), "student") +
        ", " + counted(int(stages.size()), "stage") + ", " + counted(most_points(stages), "point") +
        "</p></header>\n" + section("Points", matrix(marks, stages)) +
        section("Known mistakes", mistakes(marks)) + section("Hardest cases", cases(marks)) +
        section("Files that are alike", alike(likeness(results, project, marks)));
    write_text(results / "class.html", page("Class report", body));
}

}  // namespace rt::grade
