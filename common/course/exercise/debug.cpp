#include "common/course/exercise/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/failing_question.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/wrap.hpp"

#include <cstdio>
#include <cstdlib>
#include <optional>

namespace rt {

namespace {

constexpr std::chrono::seconds case_limit{10};  // as for a suite

/// A case of one of a stage's suites, in one precision.
struct SuiteCase {
    std::string name;
    std::string suite;  ///< "" or "_trace"
    std::string word;   ///< "double" or "float"
};

/// The case whose name contains the words; without words, the failing case that the last check has
/// shown, or the first.
std::optional<SuiteCase> find_case(int stage, const std::string& words) {
    const std::string shown = shown_case(stage);
    std::optional<SuiteCase> first;
    for (const char* const word : {"double", "float"})
        for (const char* const suite : {"", "_trace"})
            for (const CaseResult& each :
                 last_results(stage_target(stage, std::string(suite) + "_test_" + word))) {
                if (words.empty() ? each.passed : each.name.find(words) == std::string::npos)
                    continue;
                const SuiteCase found{each.name, suite, word};
                if (words.empty() && each.name == shown) return found;
                if (!first) first = found;
            }
    return first;
}

SuiteCase case_to_debug(int stage, const std::string& words) {
    const std::string check = "./course check " + std::to_string(stage);
    if (Workbook(stage).files().empty()) throw not_started(stage);
    const std::optional<SuiteCase> found = find_case(stage, words);
    if (!found && words.empty())
        throw InputError({}, tr("no case failed in the last check: {check}, or name a case in "
                                "quotes: ./course debug {stage} \"CASE\"",
                                {{"check", check}, {"stage", stage}}));
    if (!found)
        throw InputError({}, tr("no case of the last check is called \"{words}\": {check}",
                                {{"words", words}, {"check", check}}));
    return *found;
}

/// The name as Catch2 reads it, in quotes: with a backslash before what it takes for more than
/// text.
std::string quoted(const std::string& case_name) {
    std::string text;
    for (const char c : case_name) {
        if (c == '"' || c == '\\' || c == ',') text += '\\';
        text += c;
    }
    return '"' + text + '"';
}

/// The program of the case that is debugged, by a name that an editor's settings can have.
Command program_of_case() {
    return {(build_folder / "debug_case").string(), "--input-file",
            (build_folder / "debug_case.txt").string()};
}

/// Makes program_of_case() run the case. Its environment is in debug_case.env, with the number of
/// calls until the failure, which it returns: 0 if the case ends otherwise, as with a crash.
long prepare(const std::string& target, const std::string& case_name) {
    const StatusLine status(tr("looking for the call that fails …"));
    fs::remove(build_folder / "debug_case");
    fs::create_symlink(target, build_folder / "debug_case");
    write_text(build_folder / "debug_case.txt", quoted(case_name) + "\n");
    const TemporaryFolder folder(build_folder);
    const std::string file = (folder.path() / "calls").string();
    Command command = {"env", "RAYSTEPS_CALLS=" + file};
    const Command program = program_of_case();
    command.insert(command.end(), program.begin(), program.end());
    const ProcessResult ending = run_captured(command, case_limit);
    long calls = 0;
    if (fs::exists(file)) calls = std::atol(read_text(file).c_str());
    write_text(build_folder / "debug_case.env", "RAYSTEPS_STOP_AT=" + std::to_string(calls) + "\n");
    if (calls == 0 && !ending.out_of_time && ending.crash.empty() && ending.status == 0)
        throw InputError({},
                         tr("the case passes with this file: ./course check tests the file again"));
    if (ending.out_of_time)
        print_line(
            wrapped(tr("The case does not end: Ctrl-C stops it where it is, and backtrace "
                       "shows how it came there.")));
    return calls;
}

/// The debugger's command: it runs the program up to the call, or up to a crash.
Command debugger_of(long calls) {
    const std::string number = std::to_string(calls);
    Command command;
    if (is_installed("gdb")) {
        command = {"gdb", "-q", "-iex", "set debuginfod enabled off", "-ex", "set confirm off"};
        if (calls > 0)
            for (const std::string& each :
                 {std::string("break raysteps_stop"), "set environment RAYSTEPS_STOP_AT " + number,
                  std::string("run"), std::string("finish"), std::string("info args")})
                command.insert(command.end(), {"-ex", each});
        else
            command.insert(command.end(), {"-ex", "run", "-ex", "backtrace"});
        command.push_back("--args");
    } else {
        command = {"lldb"};
        if (calls > 0)
            for (const std::string& each :
                 {std::string("breakpoint set --name raysteps_stop"),
                  "settings set target.env-vars RAYSTEPS_STOP_AT=" + number, std::string("run"),
                  std::string("finish"), std::string("frame variable")})
                command.insert(command.end(), {"-o", each});
        else
            command.insert(command.end(), {"-o", "run", "-o", "bt"});
        command.push_back("--");
    }
    const Command program = program_of_case();
    command.insert(command.end(), program.begin(), program.end());
    return command;
}

}  // namespace

int debug(int stage, const std::string& words, bool starts) {
    if (starts && !is_installed("gdb") && !is_installed("lldb"))
        throw InputError({}, tr("no debugger is installed: apt-get install gdb, or on macOS "
                                "xcode-select --install, which brings lldb"));
    read_project_translations(step_path(stage, "sentences"));
    const SuiteCase chosen = case_to_debug(stage, words);
    const std::string target = stage_target(stage, chosen.suite + "_debug_" + chosen.word);
    build({target});
    const long calls = prepare(target, chosen.name);
    const std::string remark = chosen.word == "float" ? "  " + tr("(in float only)") : "";
    const std::string stop =
        calls > 0 ? tr("The debugger stops in your function, in the last call before the failure. "
                       "Then: next, step, print NAME, backtrace, quit.")
                  : tr("The debugger stops where the program ends.");
    print_line(wrapped(tr(chosen.name) + remark));
    print_line(wrapped(stop));
    std::fflush(stdout);
    return starts ? run_process(debugger_of(calls)) : 0;
}

}  // namespace rt
