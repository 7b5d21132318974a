// The commands for students.
#include "common/course/book/book.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/command_line.hpp"
#include "common/course/exercise/commands.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/own/own.hpp"
#include "common/course/view/view.hpp"
#include "common/system/files.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <sstream>

namespace rt {

namespace {

/// "3;sphere,5" in CMake's form: "3;3;5". Throws InputError if one is not a stage.
std::string parse_stages(std::string text) {
    std::ranges::replace(text, ',', ';');
    std::istringstream in(text);
    std::string stages;
    for (std::string word; std::getline(in, word, ';');)
        stages += (stages.empty() ? "" : ";") +
                  (word == "all" ? word : std::to_string(parse_stage(word)));
    return stages;
}

/// "ROW,COLUMN"
bool is_pixel(const std::string& word) {
    return two_numbers(word, ',').has_value();
}

/// Both pictures of a stage in a browser.
int view_stage(int stage) {
    choose_reference("");
    return view({.project = project_folder,
                 .build = build_folder,
                 .stage = stage,
                 .language = project_language(),
                 .rebuild = [](int shown) {
                     const Build built = try_build(
                         {stage_target(shown), stage_target(shown, "_reference_program")});
                     return built.succeeded ? "" : first_error(built.output);
                 }});
}

ComparisonRequest comparison(const Words& words, const Command& rest) {
    const int stage = parse_stage(words.stage);
    const std::string references = parse_stages(words.reference);
    choose_reference(references);
    return {.stage = stage,
            .all_mine = words.mine || !references.empty(),
            .references = references,
            .words = rest,
            .all = words.all};
}

int explain(const Words& words, Command rest) {
    std::string which;
    const auto pixel = std::ranges::find_if(rest, is_pixel);
    if (pixel != rest.end()) {
        which = *pixel;
        rest.erase(pixel);
    }
    return explain_pixel(comparison(words, rest), which);
}

int own(const Words& words) {
    if (!words.check) return lay_out_own(project_folder, words.place);
    const fs::path program = own_program(words.place);
    const std::string reference = stage_target(own_check_stage, "_reference_program");
    build({reference});
    return check_own({.program = program,
                      .reference = build_folder / reference,
                      .project = project_folder,
                      .limit = std::chrono::seconds(words.seconds)});
}

int test(Command words) {
    std::optional<int> stage;
    if (!words.empty() && words[0].rfind('-', 0) != 0) {
        stage = parse_stage(words[0]);
        words.erase(words.begin());
    }
    return run_tests(stage, words);
}

}  // namespace

void Commands::add_student_commands() {
    using Rest = const Command&;
    add_of_stage("start N", "create your own file: steps/stepNN_…/student/", [this](Rest) {
        start(stage());
        return 0;
    });
    CLI::App* check_command = add_of_stage(
        "check N", "test it, explain a failure, compare the pictures; --all: everything",
        [this](Rest) {
            return words_.sanitize ? check_with_sanitizers(stage()) : check(stage(), words_.all);
        });
    check_command->add_flag("--all", words_.all,
                            "print every case, and lines to paste into a test");
    check_command->add_flag("--sanitize", words_.sanitize,
                            "search for undefined behavior with AddressSanitizer and "
                            "UndefinedBehaviorSanitizer");
    add_of_stage("watch N", "check again whenever you save", [this](Rest) {
        watch(stage());
        return 0;
    });
    add_of_stage("hint N [LEVEL]", "show the next of three hints, or 1, 2 or 3 again",
                 [this](Rest) {
                     show_hint(stage(), words_.level);
                     return 0;
                 })
        ->add_option("LEVEL", words_.level, "1, 2 or 3; the next if not given")
        ->check(CLI::Range(1, hint_levels).description(""))
        ->type_name("");
    add_of_program(
        "run N [scene.rt] [options]", "render its scene, or yours; --help lists options",
        [this](Rest rest) { return run_stage(stage(), rest, parse_stages(words_.reference)); });
    add_of_program("compare N [scene.rt] [options]",
                   "your picture, the reference's, the difference",
                   [this](Rest rest) { return compare_pictures(comparison(words_, rest)); });
    add_of_program("explain N [ROW,COLUMN]", "your numbers for a pixel beside the reference's",
                   [this](Rest rest) { return explain(words_, rest); })
        ->add_flag("--all", words_.all, "every line that differs, not only the first");
    CLI::App* debug_command =
        add_of_stage("debug N [CASE]", "start gdb or lldb at the call that fails",
                     [this](Rest) { return debug(stage(), words_.case_name, !words_.prepare); });
    debug_command
        ->add_option("CASE", words_.case_name,
                     "words of a case's name, in quotes; the first that fails if not given")
        ->type_name("");
    debug_command->add_flag("--prepare", words_.prepare,
                            "start none: VS Code does, by .vscode/launch.json");
    add_of_stage("view [N]", "your picture and the reference's in a browser, with a movable camera",
                 [this](Rest) { return view_stage(stage()); });
    add_of_stage("solution N", "show the reference, once you have passed or at the second call",
                 [this](Rest) { return show_solution(stage()); });
    add_of_stage("reset N", "copy the starter again; your files are kept beside", [this](Rest) {
        reset(stage());
        return 0;
    });
    CLI::App* own_command =
        add("own DIR", "begin a ray tracer of your own with your stages; --check compares it",
            [this](Rest) { return own(words_); });
    own_command->add_option("DIR", words_.place, "a new folder, or with --check an older one")
        ->required()
        ->type_name("");
    own_command->add_flag("--check", words_.check,
                          "compare the pictures of DIR/build/tracer with the reference's");
    own_command
        ->add_option("--seconds", words_.seconds,
                     "the time limit of --check for a scene, 1 to 3600; 60 if not given")
        ->check(CLI::Range(1, 3600).description(""))
        ->type_name("S");
    CLI::App* book_command =
        add("book", "read the pages in a browser, with search, hints and contracts", [this](Rest) {
            return book({.project = project_folder,
                         .out = words_.out,
                         .pdf = words_.pdf,
                         .source = words_.source});
        });
    book_command->add_option("--out", words_.out, "write the site to this folder instead")
        ->type_name("DIR");
    book_command
        ->add_option("--source", words_.source,
                     "where its links to files lead: https://github.com/NAME/raysteps/blob/main")
        ->needs("--out")
        ->type_name("URL");
    book_command
        ->add_option("--pdf", words_.pdf, "print the stages' pages into this folder instead")
        ->excludes("--out")
        ->type_name("DIR");
    // The arguments, also options, are ctest's.
    add("test [N] [options of ctest]", "run the stage's suite, or all tests",
        [this](Rest rest) {
            if (!wants_help(rest)) return test(rest);
            show_help(*app_.get_subcommands()[0]);
            print_line(tr("Such as -R NAME, --rerun-failed; ctest --help lists them."));
            return 0;
        })
        ->prefix_command()
        ->set_help_flag();
}

}  // namespace rt
