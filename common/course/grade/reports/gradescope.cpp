#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/results/submissions.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/readable.hpp"
#include "common/system/translation.hpp"

#include <nlohmann/json.hpp>

namespace rt::grade {

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

void check_gradescope_file(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return;
    if (std::filesystem::is_regular_file(file)) {
        const std::string text = read_text(file);
        const Json older = Json::parse(text, nullptr, /*allow_exceptions=*/false);
        if (text.empty() || (older.is_object() && older.contains("score"))) return;
    }
    throw InputError({file}, "is no results.json, and would be replaced");
}

void write_gradescope(const std::filesystem::path& file, const std::vector<Mark>& marks) {
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
