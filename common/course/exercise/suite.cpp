#include "common/course/exercise/suite.hpp"

#include "common/course/build/project.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <array>
#include <regex>

namespace rt {

namespace {

constexpr std::chrono::seconds suite_time_limit{10};  // the slowest suite takes one

/// The usual cause of the signal.
std::string meaning_of(const std::string& crash) {
    if (crash == "Segmentation fault")
        return tr(
            "It used memory that is not its own: a function that calls itself without end, a null "
            "pointer, or an index out of range.");
    if (crash == "Aborted") return tr("An assertion failed, or std::abort was called.");
    if (crash == "Floating point exception") return tr("A whole number was divided by 0.");
    if (crash == "Killed") return tr("The system does so when memory runs out.");
    return "";
}

/// "your code crashed: Segmentation fault. It used memory …"
std::string crashed(const std::string& crash, const std::string& cause) {
    const std::string sentence = tr("your code crashed: {signal}.", {{"signal", crash}});
    return cause.empty() ? sentence : sentence + " " + cause;
}

}  // namespace

std::vector<CaseResult> last_results(const std::string& program) {
    const std::filesystem::path report = report_of(program);
    if (!std::filesystem::exists(report)) return {};
    return read_report(read_text(report));
}

std::string take_assertion(std::string& output) {
    constexpr const char* no_value =
        to_translate("A std::optional without a value was read, by * or ->");
    constexpr const char* out_of_range =
        to_translate("An index is out of range, as 2 is for two elements");
    struct Cause {
        const char* condition;
        const char* sentence;
    };
    constexpr std::array<Cause, 6> causes = {{
        {"_M_is_engaged()", no_value},
        {"on a disengaged value", no_value},
        {"this->size()", out_of_range},
        {"out-of-bounds", out_of_range},
        {"out of bounds", out_of_range},
        {"", to_translate("An assertion failed")},
    }};
    static const std::regex assertion(
        R"((?:\S+: )?(\S+:\d+): .*([Aa]ssertion ('.*'|`.*'|.*) failed.*))", std::regex::optimize);
    std::smatch match;
    std::string rest;
    std::string sentence;
    for (const std::string& line : lines_of(output)) {
        if (line.size() > 2000 || !std::regex_match(line, match, assertion)) {
            rest += line + "\n";
            continue;
        }
        const auto* const cause = std::find_if(
            causes.begin(), causes.end(),
            [&](const Cause& each) { return line.find(each.condition) != std::string::npos; });
        sentence = tr(cause->sentence) + " (" + match[1].str() + ": " + match[2].str() + ")";
    }
    output = rest;
    return sentence;
}

void SuiteResult::add(const SuiteResult& later) {
    cases.insert(cases.end(), later.cases.begin(), later.cases.end());
    if (ended.empty()) ended = later.ended;
    not_reached += later.not_reached;
    output += later.output;
}

std::filesystem::path report_of(const std::string& program) {
    return build_folder / (program + ".report");
}

SuiteResult run_suite(const std::string& program) {
    const std::filesystem::path report = report_of(program);
    std::filesystem::remove(report);
    const ProcessResult ending =
        run_captured({"env", "RAYSTEPS_REPORT=" + report.string(),
                      (build_folder / program).string(), "--out", "/dev/null"},
                     suite_time_limit);
    if (!ending.out_of_time && !ending.crash.empty() && is_stopped(ending.status))
        throw InputError({}, tr("{program} was told to stop before its end ({signal}), which says "
                                "nothing about your code: check it again",
                                {{"program", program}, {"signal", ending.crash}}));
    SuiteResult result{.output = ending.output};
    if (std::filesystem::exists(report)) {
        const std::string text = read_text(report);
        result.cases = read_report(text);
        result.not_reached = std::max(cases_in_suite(text) - int(result.cases.size()), 0);
    }
    if (ending.out_of_time)
        result.ended = tr("your code does not end: it was stopped after {seconds} s.",
                          {{"seconds", std::to_string(suite_time_limit.count())}});
    else if (!ending.crash.empty()) {
        const std::string assertion = take_assertion(result.output);
        result.ended =
            crashed(ending.crash, assertion.empty() ? meaning_of(ending.crash) : assertion + ".");
    } else if (!std::filesystem::exists(report)) {
        result.ended =
            tr("your code ended the program before the first case: remove a main function of "
               "yours, and std::exit.");
    }
    if (!result.cases.empty()) result.cases.back().ended = result.ended;
    return result;
}

}  // namespace rt
