#include "common/course/exercise/compare.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/course/exercise/log_text.hpp"
#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/status_line.hpp"
#include "common/system/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace rt {

namespace {

constexpr std::chrono::milliseconds reference_limit = std::chrono::minutes(10);
constexpr std::chrono::milliseconds least_limit = std::chrono::seconds(10);  // as for a suite
constexpr int slower_at_most = 20;                                           // than the reference
constexpr const char* no_picture = "with these options no picture is made: nothing is compared";

std::string my_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, contest.all_mine ? "" : "_checked");
}

std::string reference_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, "_reference_program");
}

void build_both(const ComparisonRequest& contest) {
    build({my_program(contest), reference_program(contest)});
}

/// A program's output. Without a result, throws InputError or ProgramError.
std::string answer(const std::string& program, const ComparisonRequest& contest,
                   const Command& more, std::chrono::milliseconds limit) {
    Command command = {(build_folder / program).string()};
    command.insert(command.end(), contest.words.begin(), contest.words.end());
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult ending = run_captured(command, limit);
    const std::string seconds = std::to_string(limit.count() / 1000) + " s";
    if (ending.out_of_time)
        throw InputError({}, program == my_program(contest)
                                 ? "your code does not end: it was stopped after " + seconds
                                 : program + " was stopped after " + seconds);
    if (!ending.crash.empty()) throw InputError({}, program + " crashed: " + ending.crash);
    if (ending.status != 0) throw ProgramError(ending.output);
    return ending.output;
}

template <class Result>
struct Both {
    Result mine;
    Result reference;
};

/// Calls `run(program, limit)` for both programs, the reference's first: the student's gets a limit
/// in proportion to the reference's time, so that an endless loop is stopped soon.
template <class Run>
auto run_both(const ComparisonRequest& contest, const Run& run) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    auto reference = run(reference_program(contest), reference_limit);
    const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
    auto mine = run(my_program(contest), std::max(least_limit, slower_at_most * took));
    return Both<decltype(mine)>{std::move(mine), std::move(reference)};
}

Comparison compare_both(const ComparisonRequest& contest) {
    const StatusLine status("drawing both pictures …");
    const auto both = run_both(contest, [&contest](const std::string& program, auto limit) {
        const TemporaryFolder folder(build_folder);
        const std::string file = (folder.path() / "picture.png").string();
        answer(program, contest, {"--quiet", "-o", file}, limit);
        if (!std::filesystem::exists(file)) throw InputError({}, no_picture);
        return read_png(file);
    });
    return compare(both.mine, both.reference);
}

Both<std::string> explain_both(const ComparisonRequest& contest, const std::string& pixel) {
    const StatusLine status("explaining the pixel …");
    return run_both(contest, [&](const std::string& program, auto limit) {
        return answer(program, contest, {"--pixel", pixel}, limit);
    });
}

/// The command that explains the same picture.
std::string explain_command(const ComparisonRequest& contest) {
    std::string command = "./course explain " + std::to_string(contest.stage);
    std::string references = contest.references;
    std::replace(references.begin(), references.end(), ';', ',');
    if (!references.empty())
        command += " --reference " + references;
    else if (contest.all_mine)
        command += " --mine";
    for (const std::string& word : contest.words) command += " " + shell_word(word);
    return command;
}

/// Reports whose files the student's program consists of.
void show_parts(const ComparisonRequest& contest) {
    if (contest.all_mine)
        warn_of_earlier(contest.stage, contest.references);
    else
        show_references_used(contest.stage);
}

}  // namespace

int compare_pictures(const ComparisonRequest& contest) {
    const std::string file = "renders/" + stage_target(contest.stage, "_compare.png");
    for (const std::string& word : contest.words) {
        if (word.starts_with("-o") || word.starts_with("--output"))
            throw InputError({}, "compare writes " + file + ", and has no " + word);
        const std::string option = word.substr(0, word.find('='));
        if (option == "--pixel" || option == "--rays" || option == "--requirements")
            throw InputError({}, no_picture);
    }
    build_both(contest);
    const Comparison comparison = compare_both(contest);
    write_png((project_folder / file).string(), comparison.side_by_side, {});
    if (isatty(STDOUT_FILENO) == 1)
        std::fputs(preview(comparison.side_by_side, terminal_columns()).c_str(), stdout);
    std::printf("%s: yours, the reference's, the difference\n%s\n", file.c_str(),
                summary(comparison).c_str());
    show_parts(contest);
    if (!comparison.center) return 0;
    std::printf("Why? %s\n", explain_command(contest).c_str());
    return 1;
}

int explain_pixel(const ComparisonRequest& contest, std::string pixel) {
    build_both(contest);
    if (pixel.empty()) {
        const Comparison comparison = compare_both(contest);
        std::printf("%s\n", summary(comparison).c_str());
        if (!comparison.center) {
            show_parts(contest);
            return 0;
        }
        std::puts("");
        pixel = std::to_string(comparison.center->row) + "," +
                std::to_string(comparison.center->column);
    }
    const auto both = explain_both(contest, pixel);
    std::fputs(text(compare_logs(both.mine, both.reference)).c_str(), stdout);
    show_parts(contest);
    return 0;
}

}  // namespace rt
