// The commands for lecturers and for authors of stages.
#include "common/course/authoring/commands.hpp"
#include "common/course/command_line.hpp"
#include "common/course/exercise/commands.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/handout/handout.hpp"
#include "common/system/translation.hpp"

namespace rt {

void Commands::add_author_commands() {
    using Rest = const Command&;
    add("update NEW", "install a newer hand-out, folder or archive; your files stay",
        [this](Rest) { return update(words_.place); })
        ->add_option("NEW", words_.place, "the hand-out")
        ->required()
        ->type_name("");
    add("audit [N]", "test that each stage, or stage N, is complete",
        [this](Rest) {
            return audit(words_.stage.empty() ? std::nullopt : std::optional(stage()));
        })
        ->group(authors)
        ->add_option("N", words_.stage, "a number or a name; the default is all stages")
        ->type_name("");
    add("measure [STUDY…]",
        "measure speed against accuracy on this machine: docs/reference/accuracy.md", measure)
        ->allow_extras()
        ->group(authors);
    // The grader answers --help.
    add("grade SUBMISSIONS… --out DIR", "grade in a sandbox; --help lists options", run_grader)
        ->prefix_command()
        ->group(authors)
        ->set_help_flag();
    CLI::App* handout_command =
        add("handout DIR", "write a copy without the solutions, for students; or DIR.tar.gz",
            [this](Rest) { return hand_out(words_.place, words_.also, words_.selection); });
    handout_command->group(authors);
    handout_command->add_option("DIR", words_.place, "a new folder or archive")
        ->required()
        ->type_name("");
    handout_command
        ->add_option("--also", words_.also,
                     "another processor that it is for, too: aarch64 or x86_64")
        ->type_name("PROCESSOR");
    handout_command
        ->add_option_function<std::string>(
            "--stages",
            [this](const std::string& stages) { select_stages(words_.selection, stages); },
            to_translate("those whose pages, hints and starters students get: 1-5,9"))
        ->type_name("STAGES");
    handout_command->add_option("--hints", words_.selection.hints, "levels of hints, 0 to 3")
        ->check(CLI::Range(0, hint_levels).description(""))
        ->type_name("LEVELS");
    handout_command->add_flag_callback(
        "--without-answers", [this] { words_.selection.answers = false; },
        to_translate("without the answers to the pages' questions"));
    handout_command
        ->add_option_function<std::string>(
            "--lang",
            [this](const std::string& language) { select_language(words_.selection, language); },
            to_translate("the language of the pages and of ./course: fr"))
        ->type_name("LANGUAGE");
}

}  // namespace rt
