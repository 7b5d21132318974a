#include "common/course/authoring/commands.hpp"

#include "common/course/authoring/known_mistakes.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/image/png.hpp"
#include "common/stages/graded_file.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

namespace rt {

namespace {

constexpr std::size_t fewest_mistakes = 8;
constexpr std::size_t fewest_alternatives = 3;

/// The existing and missing parts of one stage.
class Findings {
public:
    explicit Findings(int stage) : name_(stage_name(stage)) {}

    void require(bool holds, const std::string& what) {
        const bool reported = std::ranges::count(missing_, what) > 0;
        if (!holds && !reported) missing_.push_back(what);
    }
    void note(const std::string& what) { notes_ += (notes_.empty() ? "" : ", ") + what; }

    /// Prints them. Returns true if nothing is missing.
    [[nodiscard]] bool explain() const {
        std::printf("%s %-22s %s\n", missing_.empty() ? "✓" : "✗", name_.c_str(), notes_.c_str());
        for (const std::string& what : missing_)
            std::printf("    %s\n", styled(what, Style::bad).c_str());
        std::fflush(stdout);
        return missing_.empty();
    }

private:
    std::string name_;
    std::string notes_;
    std::vector<std::string> missing_;
};

bool is_file(const std::string& path) {
    std::error_code none;
    return fs::is_regular_file(project_folder / path, none) &&
           fs::file_size(project_folder / path, none) > 0;
}

/// The names in "figures/NAME.svg", as a page shows them.
std::set<std::string> figures_of(const std::string& page) {
    std::set<std::string> names;
    const std::string word = "](figures/";
    for (std::size_t i = page.find(word); i != std::string::npos; i = page.find(word, i + 1)) {
        const std::size_t start = i + word.size();
        names.insert(page.substr(start, page.find(')', start) - start));
    }
    return names;
}

/// The reference draws the small picture, with which `check` compares the student's.
void look_at_small_picture(int stage, Findings& findings) {
    const std::string name(stage_name(stage));
    const std::string file = "docs/pictures/small/" + name + ".png";
    findings.require(is_file(file), file + " does not exist");
    if (!is_file(file)) return;
    const TemporaryFolder folder(build_folder);
    const std::string drawn = (folder.path() / "drawn.png").string();
    const ProcessResult ending =
        run_captured({(build_folder / name).string(), "--quiet", "--size", "128x96", "-o", drawn},
                     std::chrono::seconds(20));
    findings.require(ending.status == 0, "the reference draws no picture: " + ending.output);
    if (ending.status != 0) return;
    const Comparison comparison =
        compare(read_png(drawn), read_png((project_folder / file).string()));
    findings.require(!comparison.center, file + " is not the reference's picture: ./course run " +
                                             std::to_string(stage) + " --size 128x96 -o " + file);
}

void look_at_page(int stage, Findings& findings) {
    const std::string name(stage_name(stage));
    const std::string file = "docs/" + name + ".md";
    findings.require(is_file(file), file + " does not exist");
    if (!is_file(file)) return;
    const std::string page = read_text(project_folder / file);
    const std::set<std::string> figures = figures_of(page);
    findings.require(!figures.empty(), file + " contains no figure");
    for (const std::string& figure : figures)
        findings.require(is_file("docs/figures/" + figure),
                         "docs/figures/" + figure + " does not exist");
    findings.require(page.find("pictures/" + name + ".png") != std::string::npos,
                     file + " does not show the stage's picture");
    findings.require(page.find("gallery/" + name + ".png") != std::string::npos,
                     file + " does not show the stage's picture of the gallery");
    for (const char* command : {"./course run ", "./course check "})
        findings.require(page.find(command + std::to_string(stage)) != std::string::npos,
                         file + " does not contain " + command + std::to_string(stage));
    findings.note(std::to_string(figures.size()) + (figures.size() == 1 ? " figure" : " figures"));
}

void look_at_hints(int stage, Findings& findings) {
    const std::string file = step_path(stage, "hints.md");
    for (int level = 1; level <= hint_levels; ++level)
        findings.require(is_file(file) && !hint_text(stage, level).empty(),
                         file + " has no hint " + std::to_string(level));
}

void look_at_mistakes(int stage, Findings& findings) {
    const std::string name(stage_name(stage));
    const std::size_t count = read_known_mistakes(project_folder, name).size() +
                              read_known_mistakes(project_folder, name + "_trace").size();
    const std::size_t others = read_right_answers(project_folder, name).size();
    findings.require(count >= fewest_mistakes, "too few known mistakes");
    findings.require(others >= fewest_alternatives, "too few other right answers");
    findings.note(std::to_string(count) + " mistakes");
    findings.note(std::to_string(others) + " other right answers");
}

std::set<std::string> passed_cases(const SuiteResult& suite) {
    std::set<std::string> names;
    for (const CaseResult& each : suite.cases)
        if (each.passed) names.insert(each.name);
    return names;
}

/// The reference passes all cases of a file's suite; the starter passes the listed ones, where a
/// miss or zero is the right answer. They are taken from `listed`.
void look_at_suite(GradedFile graded, std::set<std::string>& listed, Findings& findings) {
    const std::string name = name_of(graded);
    const std::string file = file_name(graded);
    for (const char* precision : {"_float", "_double"}) {
        const SuiteResult reference = run_suite(name + "_test" + precision);
        const std::size_t cases = reference.cases.size();
        findings.require(
            cases > 0 && reference.ended.empty() && passed_cases(reference).size() == cases,
            "the reference's " + file + " does not pass" + std::string(precision));
        const SuiteResult starter = run_suite(name + "_starter_test" + precision);
        const std::set<std::string> passed = passed_cases(starter);
        findings.require(starter.ended.empty(), "the starter " + starter.ended);
        if (!graded.is_trace)
            findings.require(starter.output.find(not_written) != std::string::npos,
                             "the starter does not report that it is not written yet");
        findings.require(passed.size() < cases, "the starter's " + file + " is right");
        for (const std::string& each : passed)
            findings.require(listed.count(each) == 1, "the starter passes: " + each);
        for (const CaseResult& each : starter.cases)
            findings.require(each.passed || listed.count(each.name) == 0,
                             "passes.txt lists a case that fails: " + each.name);
        if (std::string(precision) == "_float") continue;
        for (const CaseResult& each : starter.cases) listed.erase(each.name);
        findings.note(std::to_string(cases) + " cases" + (graded.is_trace ? " of main.cpp" : "") +
                      ", the starter passes " + std::to_string(passed.size()));
    }
}

/// The suites of a stage's files, and the list of the cases that its starter passes.
void look_at_suites(int stage, Findings& findings) {
    std::set<std::string> listed = passed_by_starter(project_folder / step_path(stage, ""));
    look_at_suite(stage, listed, findings);
    if (has_trace(stage)) look_at_suite({stage, true}, listed, findings);
    for (const std::string& each : listed)
        findings.require(false,
                         step_path(stage, "starter/passes.txt lists what is no case: ") + each);
}

}  // namespace

int audit(std::optional<int> only) {
    choose_reference("all");
    std::vector<int> stages;
    std::vector<std::string> targets;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        if (only.value_or(stage) != stage || (stage >= mesh_stage && !has_meshes)) continue;
        stages.push_back(stage);
        for (const char* suffix :
             {"", "_test_float", "_test_double", "_starter_test_float", "_starter_test_double"})
            targets.push_back(stage_target(stage, suffix));
        if (!has_trace(stage)) continue;
        for (const char* suffix : {"_trace_test_float", "_trace_test_double",
                                   "_trace_starter_test_float", "_trace_starter_test_double"})
            targets.push_back(stage_target(stage, suffix));
    }
    build(targets);
    bool whole = true;
    for (const int stage : stages) {
        const std::string name(stage_name(stage));
        Findings findings(stage);
        for (const std::string& file : {"scenes/" + name + ".rt", "docs/pictures/" + name + ".png"})
            findings.require(is_file(file), file + " does not exist");
        look_at_suites(stage, findings);
        look_at_small_picture(stage, findings);
        look_at_page(stage, findings);
        look_at_hints(stage, findings);
        look_at_mistakes(stage, findings);
        whole = findings.explain() && whole;
    }
    if (!only && !has_meshes) std::puts("step13_meshes was left out: it needs OpenMesh");
    return whole ? 0 : 1;
}

}  // namespace rt
