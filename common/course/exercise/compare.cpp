#include "common/course/exercise/compare.hpp"

#include "common/image/png.hpp"
#include "common/image/preview.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"

#include <unistd.h>

#include <cstdio>

namespace rt {

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

}  // namespace rt
