#include "common/course/exercise/two_programs.hpp"

#include "common/course/build/build.hpp"
#include "common/course/exercise/earlier_stages.hpp"
#include "common/image/png.hpp"
#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

namespace rt {

void build_both(const ComparisonRequest& contest) {
    build({my_program(contest), reference_program(contest)});
}

std::string answer(const std::string& program, const ComparisonRequest& contest,
                   const Command& more, std::chrono::milliseconds limit) {
    Command command = {(build_folder / program).string()};
    command.insert(command.end(), contest.words.begin(), contest.words.end());
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult ending = run_captured(command, limit);
    const Values values = {{"program", program},
                           {"seconds", std::to_string(limit.count() / 1000)},
                           {"signal", ending.crash}};
    if (ending.out_of_time)
        throw InputError(
            {}, program == my_program(contest)
                    ? tr("your code does not end: it was stopped after {seconds} s", values)
                    : tr("{program} was stopped after {seconds} s", values));
    if (!ending.crash.empty()) throw InputError({}, tr("{program} crashed: {signal}", values));
    if (ending.status != 0) throw ProgramError(tr_lines(ending.output));
    return ending.output;
}

Comparison compare_both(const ComparisonRequest& contest) {
    const StatusLine status(tr("drawing both pictures …"));
    const auto both = run_both(contest, [&contest](const std::string& program, auto limit) {
        const TemporaryFolder folder(build_folder);
        const std::string file = (folder.path() / "picture.png").string();
        answer(program, contest, {"--quiet", "-o", file}, limit);
        if (!std::filesystem::exists(file)) throw InputError({}, tr(no_picture));
        return read_png(file);
    });
    return compare(both.mine, both.reference);
}

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

void show_parts(const ComparisonRequest& contest) {
    if (contest.all_mine)
        warn_of_earlier(contest.stage, contest.references);
    else
        std::fputs(references_used(contest.stage).c_str(), stdout);
}

}  // namespace rt
