#include "common/course/grade/reports/reports.hpp"

#include "common/course/grade/reports/html.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"

namespace rt::grade {

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

void write_junit(const std::filesystem::path& results, const std::vector<Mark>& marks) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const Mark& mark : marks) text += suite(mark);
    write_text(results / "junit.xml", text + "</testsuites>\n");
}

}  // namespace rt::grade
