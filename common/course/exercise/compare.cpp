#include "common/course/exercise/commands.hpp"

#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <unistd.h>

namespace rt {

int compare_pictures(const ComparisonRequest& contest) {
    const std::string file = "renders/" + stage_target(contest.stage, "_compare.png");
    for (const std::string& word : contest.words) {
        if (word.starts_with("-o") || word.starts_with("--output"))
            throw InputError({}, tr("compare writes {file}, and has no {option}",
                                    {{"file", file}, {"option", word}}));
        const std::string option = word.substr(0, word.find('='));
        if (option == "--pixel" || option == "--rays" || option == "--requirements")
            throw InputError({}, tr(no_picture));
    }
    build_both(contest);
    const Comparison comparison = compare_both(contest);
    write_png((project_folder / file).string(), comparison.side_by_side, {});
    if (isatty(STDOUT_FILENO) == 1) print(preview(comparison.side_by_side, terminal_columns()));
    print_line(tr("{file}: yours, the reference's, the difference", {{"file", file}}));
    print_line(summary(comparison));
    show_parts(contest);
    if (!comparison.center) return 0;
    print_line(tr("Why? {command}", {{"command", explain_command(contest)}}));
    return 1;
}

}  // namespace rt
