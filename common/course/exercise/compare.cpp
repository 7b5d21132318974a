#include "common/course/exercise/compare.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/image_diff.hpp"
#include "common/course/exercise/log_text.hpp"
#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace rt {

namespace {

constexpr std::chrono::seconds time_limit{600};

std::string my_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, contest.all_mine ? "" : "_checked");
}

std::string reference_program(const ComparisonRequest& contest) {
    return stage_target(contest.stage, "_reference_program");
}

void build_both(const ComparisonRequest& contest) {
    build({my_program(contest), reference_program(contest)});
}

/// The output of a program, which becomes an error message if the program fails.
std::string answer(const std::string& program, const ComparisonRequest& contest,
                   const Command& more) {
    Command command = {(build_folder / program).string()};
    command.insert(command.end(), contest.words.begin(), contest.words.end());
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult ending = run_captured(command, time_limit);
    if (ending.out_of_time) throw InputError({}, program + " does not end");
    if (!ending.crash.empty()) throw InputError({}, program + " crashed: " + ending.crash);
    if (ending.status != 0) throw ProgramError(ending.output);
    return ending.output;
}

Image picture(const std::string& program, const ComparisonRequest& contest) {
    const TemporaryFolder folder(build_folder);
    const std::string file = (folder.path() / "picture.png").string();
    answer(program, contest, {"--quiet", "-o", file});
    return read_png(file);
}

Comparison compare_both(const ComparisonRequest& contest) {
    return compare(picture(my_program(contest), contest),
                   picture(reference_program(contest), contest));
}

}  // namespace

int compare_pictures(const ComparisonRequest& contest) {
    build_both(contest);
    const Comparison comparison = compare_both(contest);
    const std::string file = "renders/" + stage_target(contest.stage, "_compare.png");
    write_png((project_folder / file).string(), comparison.side_by_side, {});
    if (isatty(STDOUT_FILENO) == 1)
        std::fputs(preview(comparison.side_by_side, terminal_columns()).c_str(), stdout);
    std::printf("%s: yours, the reference's, the difference\n%s\n", file.c_str(),
                summary(comparison).c_str());
    if (!comparison.center) return 0;
    std::printf("Why? ./course explain %d\n", contest.stage);
    return 1;
}

int explain_pixel(const ComparisonRequest& contest, std::string pixel) {
    build_both(contest);
    if (pixel.empty()) {
        const Comparison comparison = compare_both(contest);
        std::printf("%s\n\n", summary(comparison).c_str());
        if (!comparison.center) return 0;
        pixel = std::to_string(comparison.center->row) + "," +
                std::to_string(comparison.center->column);
    }
    const LogDiff diff =
        compare_logs(answer(my_program(contest), contest, {"--pixel", pixel}),
                     answer(reference_program(contest), contest, {"--pixel", pixel}));
    std::fputs(text(diff).c_str(), stdout);
    return 0;
}

}  // namespace rt
