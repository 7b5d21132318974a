#include "common/course/exercise/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/stages/reasons.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace rt {

namespace {

constexpr const char* test_time_limit = "300";  // seconds; an endless loop is a failure

/// Builds a program of all the student's stages. If another stage does not compile, prints how to
/// build without it.
void build_all_mine(int stage) {
    try {
        build({stage_target(stage)});
    } catch (const ProgramError& error) {
        const std::string text = error.what();
        for (int other = 1; other < stage; ++other)
            if (text.find(step_path(other, "student/")) == 0)
                throw ProgramError(
                    text + tr("Without that stage: --reference {stage}", {{"stage", other}}) +
                    "\n");
        throw;
    }
}

/// True for the option that selects the exact precision, which has a program of its own.
bool wants_exact(const Command& words) {
    const auto name = std::ranges::find(words, "--precision");
    return std::ranges::find(words, "--precision=exact") != words.end() ||
           (words.end() - name >= 2 && name[1] == "exact");
}

/// A stage's program prints errors, warnings and what it has drawn in the reader's language.
void name_sentences() {
    const auto catalogue = project_folder / "lang" / project_language() / "program.po";
    if (project_language().empty()) return;
    setenv(sentences_variable, catalogue.c_str(), 1);
    setenv("RAYSTEPS_NOT_WRITTEN", tr(not_written).c_str(), 1);
}

int run_built(const std::string& program, const Command& words) {
    Command command = {(build_folder / program).string()};
    command.insert(command.end(), words.begin(), words.end());
    return run_process(command);
}

}  // namespace

int run_stage(int stage, const Command& words, const std::string& references) {
    choose_reference(references);
    std::string name = stage_target(stage);
    if (wants_exact(words)) {
        if (is_handout(project_folder))
            throw InputError({}, tr("--precision exact is not part of this hand-out"));
        name = stage_target(stage, "_exact");
        build({name});
    } else {
        build_all_mine(stage);
        warn_of_earlier(stage, references);
    }
    name_sentences();
    return run_built(name, words);
}

int run_tests(std::optional<int> stage, const Command& words) {
    // One more than cores: tests of time limits mostly wait.
    const std::string at_once = std::to_string(std::thread::hardware_concurrency() + 1);
    Command command = {"ctest", "--test-dir", build_folder.string(), "-j",
                       at_once, "--timeout",  test_time_limit};
    command.insert(command.end(),
                   {"--output-on-failure", "--progress", "--no-label-summary", "--no-tests=error"});
    std::vector<std::string> targets;
    if (stage) {
        targets = {stage_target(*stage, "_suites_float"), stage_target(*stage, "_suites_double")};
        command.insert(command.end(), {"-L", "^" + stage_target(*stage) + "$"});
    }
    command.insert(command.end(), words.begin(), words.end());
    choose_reference("");
    build(targets);
    const int status = run_process(command);
    if (!stage && !has_meshes)
        print_line(tr("step13_meshes was left out: ./course test 13 installs OpenMesh"));
    print_line((status == 0 ? tr("every test passed") : tr("not every test passed: see above")));
    return status;
}

int run_grader(const Command& words) {
    choose_reference("all");
    std::vector<std::string> targets = {"grading"};
    if (std::ranges::find(words, "--self-test") != words.end())
        targets.insert(targets.end(), {"seal_test", "attacks_test"});
    build(targets);
    return run_built("grade", words);
}

}  // namespace rt
