#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/reports/html.hpp"
#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/submissions.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt::grade {

void write_grade_book(const fs::path& results, const std::vector<Mark>& marks, const Term& term) {
    const std::map<int, int> stages = graded_stages(marks);
    const std::vector<StudentMarks> all = submissions(marks, term);
    const bool remarks =
        std::ranges::any_of(all, [](const auto& each) { return !each.remarks.empty(); });
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

namespace {

std::string attribute(const std::string& name, const std::string& value) {
    return " " + name + "=\"" + escaped(value) + "\"";
}

std::string test_case(const std::string& suite, const std::string& name,
                      const std::string& inside) {
    const std::string start =
        "    <testcase" + attribute("classname", suite) + attribute("name", name);
    return start + (inside.empty() ? "/>\n" : ">" + inside + "</testcase>\n");
}

std::string failure(const CaseMark& each) {
    if (each.passed) return "";
    return "<failure" + attribute("message", each.words.substr(0, each.words.find('\n'))) + ">" +
           escaped(each.place + "\n" + each.words) + "</failure>";
}

std::string suite(const Mark& mark) {
    const std::string name = mark.student + "." + name_of(mark.stage);
    std::string cases;
    std::size_t failures = 0;
    for (const CaseMark& each : mark.cases) {
        cases += test_case(name, each.name, failure(each));
        if (!each.passed) ++failures;
    }
    const bool missing = mark.verdict == Verdict::missing;
    const bool refused = mark.verdict == Verdict::refused || mark.verdict == Verdict::postponed;
    if (missing)
        cases +=
            test_case(name, "is submitted", "<skipped" + attribute("message", mark.words) + "/>");
    if (refused)
        cases += test_case(name, "can be graded", "<error>" + escaped(mark.words) + "</error>");
    const bool untested = mark.untested_points() > 0;
    if (untested)
        cases += test_case(name, "both files can be graded",
                           "<skipped" + attribute("message", mark.words) + "/>");
    const auto count = [&](const std::string& what, std::size_t value) {
        return attribute(what, std::to_string(value));
    };
    return "  <testsuite" + attribute("name", name) +
           count("tests", mark.cases.size() + (missing || refused || untested ? 1 : 0)) +
           count("failures", failures) + count("errors", refused ? 1 : 0) +
           count("skipped", missing || untested ? 1 : 0) + ">\n" + cases + "  </testsuite>\n";
}

}  // namespace

void write_junit(const fs::path& results, const std::vector<Mark>& marks) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const Mark& mark : marks) text += suite(mark);
    write_text(results / "junit.xml", text + "</testsuites>\n");
}

namespace {

using Json = nlohmann::ordered_json;

Json test(const std::string& name, bool passed, int points, const std::string& output) {
    return {{"name", readable(name)},     {"score", passed ? points : 0},
            {"max_score", points},        {"status", passed ? "passed" : "failed"},
            {"output", readable(output)}, {"output_format", "text"},
            {"visibility", "visible"}};
}

std::string failure_text(const CaseMark& each) {
    return each.passed ? "" : each.place + "\n" + tr_lines(each.words);
}

void append_tests(Json& tests, const Mark& mark) {
    const std::string title = stage_title(mark.stage);
    if (mark.verdict == Verdict::missing)
        tests.push_back(test(title, false, mark.most,
                             tr("No file was submitted.") + "\n" + tr_lines(mark.words)));
    if (mark.verdict == Verdict::refused)
        tests.push_back(test(title, false, mark.most,
                             tr("Your file cannot be graded:") + "\n" + tr_lines(mark.words)));
    if (mark.verdict == Verdict::postponed)
        tests.push_back(test(title, false, mark.most,
                             tr("Your file could not be graded, through no fault of yours. Submit "
                                "it again, and inform your instructor if this repeats.")));
    for (const CaseMark& each : mark.cases) {
        tests.push_back(test(file_title({mark.stage, each.of_trace}) + tr(": ") + tr(each.name),
                             each.passed, each.points, failure_text(each)));
        if (mark.points(each.of_trace) == 0)
            tests.back()["score"] = 0;  // cases that the starter passes too
    }
    if (mark.untested_points() > 0)
        tests.push_back(test(title + tr(": ") + tr("a file is missing, or cannot be graded"), false,
                             mark.untested_points(), tr_lines(mark.words)));
}

/// The diagnosis, which belongs to no single case.
std::string diagnosis(const Mark& mark) {
    const std::string& words = mark.mistake.empty() ? mark.smallest : mark.mistake;
    return words.empty() ? "" : stage_title(mark.stage) + tr(": ") + tr_lines(words) + "\n\n";
}

}  // namespace

void check_gradescope_file(const fs::path& file) {
    if (!fs::exists(file)) return;
    if (fs::is_regular_file(file)) {
        const std::string text = read_text(file);
        const Json older = Json::parse(text, nullptr, /*allow_exceptions=*/false);
        if (text.empty() || (older.is_object() && older.contains("score"))) return;
    }
    throw InputError({file}, "is no results.json, and would be replaced");
}

void write_gradescope(const fs::path& file, const std::vector<Mark>& marks) {
    int score = 0;
    std::string output;
    Json tests = Json::array();
    for (const Mark& mark : marks) {
        score += mark.points();
        output += diagnosis(mark);
        append_tests(tests, mark);
    }
    const Json json{{"score", score},
                    {"output", readable(output)},
                    {"output_format", "text"},
                    {"visibility", "visible"},
                    {"tests", tests}};
    write_text(file, json.dump(2) + "\n");
}

}  // namespace rt::grade
