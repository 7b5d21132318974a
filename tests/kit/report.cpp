// Reports the result of each case immediately, so that a crash loses no earlier result. The
// environment variable RAYSTEPS_REPORT names the file; without it nothing is reported.
//
//   cases 21                                   of the suite
//   case edges belong to the triangle (MRT §5)
//   part normal                                of the stage, at its first case: [part normal]
//   points 2                                   if its tag contains them: [2 points]; default 1
//   at tests/suites/step05_triangle_test.cpp:61       only for a failed case: its first failure
//   | intersect(Ray{…                          its lines
//   failures 1f00aa64e1b2 …                    the digests of all its failures
//   failed                                     or passed
#include "tests/kit/report.hpp"

#include "common/stages/reasons.hpp"

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Listener = Catch::EventListenerBase;
using Answer = void;
#else
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include <catch2/catch.hpp>
using Listener = Catch::TestEventListenerBase;
using Answer = bool;
#endif

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

/// The failure: a verdict's sentence alone, or any other assertion as written in the suite.
std::string failure_text(const Catch::AssertionResult& result) {
    const std::string expanded = result.getExpandedExpression();
    if (!expanded.empty() && expanded.front() == '\n')
        return expanded.substr(expanded.find_first_not_of("\n "));
    if (result.getResultType() == Catch::ResultWas::FatalErrorCondition)
        return "your code crashed: " + std::string(result.getMessage());
    std::string text = result.getExpressionInMacro();
    const std::string message = result.hasMessage() ? std::string(result.getMessage()) : "";
    // The link to a worker throws a message of its own: "Your code crashed".
    if (result.getResultType() == Catch::ResultWas::ThrewException &&
        message.rfind(rt::no_answer_start, 0) != 0)
        return text + "\n  got:      an exception: " + message;
    if (!message.empty())
        text += (text.empty() ? "" : "\n  got:      ") + message;
    else if (expanded != result.getExpression())
        text += "\n  got:      " + expanded;
    return text;
}

/// The path relative to the project's folder.
std::string place(const Catch::SourceLineInfo& source) {
    const std::string file = source.file;
    const std::size_t start = file.rfind("tests/");
    return (start == std::string::npos ? file : file.substr(start)) + ":" +
           std::to_string(source.line);
}

/// The points in tags such as "[light][2 points]".
int points_in(const std::string& tags) {
    int points = 1;
    for (std::size_t at = tags.find('['); at != std::string::npos; at = tags.find('[', at + 1))
        if (std::sscanf(tags.c_str() + at, "[%d points]", &points) == 1) break;
    return points;
}

/// The part in tags such as "[part normal][3 points]", or nothing.
std::string part_in(const std::string& tags) {
    const std::string word = "[part ";
    const std::size_t at = tags.find(word);
    if (at == std::string::npos) return "";
    const std::size_t start = at + word.size();
    return tags.substr(start, tags.find(']', start) - start);
}

class Report : public Listener {
public:
    using Listener::Listener;

    void testRunStarting(const Catch::TestRunInfo& info) override {
        Listener::testRunStarting(info);
        const char* file = std::getenv("RAYSTEPS_REPORT");
        if (file == nullptr) return;
        out_.open(file);
        std::setvbuf(stdout, nullptr, _IOLBF, 4096);  // output before a crash is kept
        out_ << "cases " << Catch::getRegistryHub().getTestCaseRegistry().getAllTests().size()
             << std::endl;
    }

    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        Listener::testCaseStarting(info);
        out_ << "case " << info.name << std::endl;
        if (const std::string part = part_in(info.tagsAsString()); !part.empty())
            out_ << "part " << part << std::endl;
        if (const int points = points_in(info.tagsAsString()); points != 1)
            out_ << "points " << points << std::endl;
        reported_ = false;
        rt::failures_of_case.clear();
    }

    Answer assertionEnded(const Catch::AssertionStats& stats) override {
        explain(stats.assertionResult);
        return Answer();
    }

    void testCaseEnded(const Catch::TestCaseStats& stats) override {
        Listener::testCaseEnded(stats);
        const bool passed = stats.totals.assertions.failed == 0;
        if (!passed) out_ << "failures " << rt::failures_of_case.text() << std::endl;
        out_ << (passed ? "passed" : "failed") << std::endl;
    }

private:
    void explain(const Catch::AssertionResult& result) {
        if (result.isOk()) return;
        rt::failures_of_case.add(failure_text(result));
        if (reported_) return;
        reported_ = true;
        if (rt::at_first_failure) rt::at_first_failure();
        out_ << "at " << place(result.getSourceInfo()) << '\n';
        const std::string remark = rt::remark_on_failure ? rt::remark_on_failure() : "";
        std::istringstream lines(failure_text(result) + "\n" + remark);
        for (std::string line; std::getline(lines, line);)
            if (remark.empty() || line.rfind("  paste:", 0) != 0) out_ << "| " << line << '\n';
        out_.flush();
    }

    std::ofstream out_;
    bool reported_ = false;
};

}  // namespace

CATCH_REGISTER_LISTENER(Report)
