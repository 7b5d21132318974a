// The commands behind `./course`.
#include "common/course/authoring/audit.hpp"
#include "common/course/authoring/measure.hpp"
#include "common/course/book/book.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/check.hpp"
#include "common/course/exercise/commands.hpp"
#include "common/course/exercise/compare.hpp"
#include "common/course/exercise/debug.hpp"
#include "common/course/exercise/explain.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/run.hpp"
#include "common/course/exercise/watch.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/course/handout/handout.hpp"
#include "common/course/handout/update.hpp"
#include "common/course/own/check_own.hpp"
#include "common/course/own/lay_out.hpp"
#include "common/course/view/view.hpp"
#include "common/system/input_error.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"
#include "common/system/two_numbers.hpp"
#include "common/system/wrap.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>

namespace {

constexpr const char* stage_option = rt::to_translate(
    "a number or a name: 5, triangle, step05_triangle; the default is your current stage");

/// The arguments of a command.
struct Words {
    std::string stage;
    bool mine = false;
    std::string reference;
    std::string place;
    std::optional<std::string> out;
    std::optional<std::string> pdf;
    std::string source;
    std::vector<std::string> also;
    rt::Selection selection;
    std::optional<int> level;
    bool check = false;
    int seconds = 60;
    bool all = false;
    bool sanitize = false;
    bool prepare = false;
    std::string case_name;
};

/// "triangle" and "step05_triangle", for each stage.
std::vector<std::string> stage_words() {
    std::vector<std::string> words;
    for (int stage = 1; stage <= int(rt::stage_names.size()); ++stage) {
        words.push_back(rt::topic_of(stage));
        words.push_back(rt::name_of(stage));
    }
    return words;
}

int parse_stage(const std::string& text) {
    const std::optional<int> stage = text.empty() ? rt::current_stage() : rt::find_stage(text);
    if (!stage)
        throw rt::InputError({}, "no stage \"" + text + "\": give a number 1 to " +
                                     std::to_string(rt::stage_names.size()) +
                                     " or a name like step05_triangle." +
                                     rt::suggestion(text, stage_words()));
    if (!rt::is_here(*stage))
        throw rt::InputError({},
                             std::string(rt::stage_name(*stage)) + " is not part of this hand-out");
    if (*stage == rt::mesh_stage && !rt::has_meshes)
        throw rt::InputError({}, std::string(rt::stage_name(*stage)) +
                                     " needs OpenMesh: libopenmesh-dev, or what your system "
                                     "calls it");
    return *stage;
}

/// "3;sphere,5" in CMake's form: "3;3;5". Throws InputError if one is not a stage.
std::string parse_stages(std::string text) {
    std::replace(text.begin(), text.end(), ',', ';');
    std::istringstream in(text);
    std::string stages;
    for (std::string word; std::getline(in, word, ';');)
        stages += (stages.empty() ? "" : ";") +
                  (word == "all" ? word : std::to_string(parse_stage(word)));
    return stages;
}

/// True for a command that only a clone has and this is a hand-out, or the other way round.
bool is_missing(const std::string& command) {
    constexpr std::array<std::string_view, 5> of_clones = {"solution", "audit", "measure", "grade",
                                                           "handout"};
    if (!rt::is_handout(rt::project_folder)) return command == "update";
    return std::find(of_clones.begin(), of_clones.end(), command) != of_clones.end();
}

/// The commands of lecturers and authors; the others are for students.
const std::string authors = "For lecturers, and for authors of stages";

/// "ROW,COLUMN"
bool is_pixel(const std::string& word) {
    return rt::two_numbers(word, ',').has_value();
}

int view(int stage) {
    rt::choose_reference("");
    return rt::view({.project = rt::project_folder,
                     .build = rt::build_folder,
                     .stage = stage,
                     .rebuild = [](int shown) {
                         const rt::Build built =
                             rt::try_build({rt::stage_target(shown),
                                            rt::stage_target(shown, "_reference_program")});
                         return built.succeeded ? "" : rt::first_error(built.output);
                     }});
}

/// True if the words ask for the help of the stage's program.
bool wants_help(const rt::Command& rest) {
    return std::any_of(rest.begin(), rest.end(),
                       [](const std::string& word) { return word == "--help" || word == "-h"; });
}

rt::ComparisonRequest comparison(const Words& words, const rt::Command& rest) {
    const int stage = parse_stage(words.stage);
    const std::string references = parse_stages(words.reference);
    rt::choose_reference(references);
    return {.stage = stage,
            .all_mine = words.mine || !references.empty(),
            .references = references,
            .words = rest,
            .all = words.all};
}

int explain(const Words& words, rt::Command rest) {
    std::string which;
    const auto pixel = std::find_if(rest.begin(), rest.end(), is_pixel);
    if (pixel != rest.end()) {
        which = *pixel;
        rest.erase(pixel);
    }
    return rt::explain_pixel(comparison(words, rest), which);
}

int own(const Words& words) {
    if (!words.check) return rt::lay_out_own(rt::project_folder, words.place);
    const std::filesystem::path program = rt::own_program(words.place);
    const std::string reference = rt::stage_target(rt::own_check_stage, "_reference_program");
    rt::build({reference});
    return rt::check_own({.program = program,
                          .reference = rt::build_folder / reference,
                          .project = rt::project_folder,
                          .limit = std::chrono::seconds(words.seconds)});
}

int test(rt::Command words) {
    std::optional<int> stage;
    if (!words.empty() && words[0].rfind('-', 0) != 0) {
        stage = parse_stage(words[0]);
        words.erase(words.begin());
    }
    return rt::run_tests(stage, words);
}

/// Prints what the command itself does with its arguments.
void show_help(const CLI::App& command) {
    constexpr std::size_t column = 21;  // of the descriptions
    std::string page = command.get_description() + "\n\n";
    for (const CLI::Option* option : command.get_options()) {
        std::string line = "  " + option->get_name() + " " + option->get_type_name();
        line.resize(std::max(line.size() + 1, column), ' ');
        page += line + option->get_description() + "\n";
    }
    std::fputs(rt::wrapped_page(page, column).c_str(), stdout);
}

/// The commands. CLI11 parses their arguments, prints their help, and starts them.
class Commands {
public:
    Commands() {
        app_.require_subcommand(0, 1);
        app_.get_formatter()->label("REQUIRED", "(required)");
        app_.get_formatter()->label("Needs", "with");
        add_student_commands();
        add_author_commands();
    }

    int run(int argc, char** argv);

private:
    /// A command with the words that CLI11 leaves to it; returns the exit status.
    using Body = std::function<int(const rt::Command& rest)>;

    void add_student_commands();
    void add_author_commands();
    /// The first word of the usage is the command's name.
    CLI::App* add(const std::string& usage, const std::string& description, const Body& body);
    /// A command with a stage, which may be left out.
    CLI::App* add_of_stage(const std::string& usage, const std::string& description,
                           const Body& body);
    /// A command that hands words over to the stage's program, which answers --help.
    CLI::App* add_of_program(const std::string& usage, const std::string& description,
                             const Body& body);
    void print_summary() const;
    void print_list() const;
    [[noreturn]] void refuse(const CLI::ParseError& error, const std::string& first) const;
    [[nodiscard]] std::vector<std::string> command_names() const;
    [[nodiscard]] int stage() const { return parse_stage(words_.stage); }

    CLI::App app_{"Raysteps: a ray tracer in thirteen steps", "./course"};
    Words words_;
    int status_ = 0;
};

CLI::App* Commands::add(const std::string& usage, const std::string& description,
                        const Body& body) {
    CLI::App* command = app_.add_subcommand(usage.substr(0, usage.find(' ')),
                                            "./course " + usage + ": " + rt::tr(description));
    command->callback([this, command, body] { status_ = body(command->remaining()); });
    return command;
}

CLI::App* Commands::add_of_stage(const std::string& usage, const std::string& description,
                                 const Body& body) {
    CLI::App* command = add(usage, description, body);
    command->add_option("N", words_.stage, stage_option)->type_name("");
    return command;
}

CLI::App* Commands::add_of_program(const std::string& usage, const std::string& description,
                                   const Body& body) {
    const auto answer = [this, body](const rt::Command& rest) {
        if (!wants_help(rest)) return body(rest);
        const CLI::App& command = *app_.get_subcommands()[0];
        show_help(command);
        const bool is_run = command.get_name() == "run";  // which builds the program
        std::printf(
            "The other options are those of the stage's program%s\n",
            is_run ? ":\n"
                   : (": ./course run " + std::to_string(stage()) + " --help lists them.").c_str());
        if (!is_run) return 0;
        std::fflush(stdout);
        return rt::run_stage(stage(), {"--help"}, "");
    };
    CLI::App* command = add_of_stage(usage, description, answer)->allow_extras();
    command->set_help_flag();
    command->add_flag("--mine", words_.mine, "use all your stages");
    command->add_option("--reference", words_.reference, "use all your stages but these: 3,5")
        ->type_name("N,N");
    return command;
}

void Commands::add_student_commands() {
    using Rest = const rt::Command&;
    add_of_stage("start N", "create your own file: steps/stepNN_…/student/", [this](Rest) {
        rt::start(stage());
        return 0;
    });
    CLI::App* check_command = add_of_stage(
        "check N", "test it, explain a failure, compare the pictures; --all: everything",
        [this](Rest) {
            return words_.sanitize ? rt::check_with_sanitizers(stage())
                                   : rt::check(stage(), words_.all);
        });
    check_command->add_flag("--all", words_.all,
                            "print every case, and lines to paste into a test");
    check_command->add_flag("--sanitize", words_.sanitize,
                            "search for undefined behavior with AddressSanitizer and "
                            "UndefinedBehaviorSanitizer");
    add_of_stage("watch N", "check again whenever you save", [this](Rest) {
        rt::watch(stage());
        return 0;
    });
    add_of_stage("hint N [LEVEL]", "show the next of three hints, or 1, 2 or 3 again",
                 [this](Rest) {
                     rt::show_hint(stage(), words_.level);
                     return 0;
                 })
        ->add_option("LEVEL", words_.level, "1, 2 or 3; the next if not given")
        ->check(CLI::Range(1, rt::hint_levels).description(""))
        ->type_name("");
    add_of_program(
        "run N [scene.rt] [options]", "render its scene, or yours; --help lists options",
        [this](Rest rest) { return rt::run_stage(stage(), rest, parse_stages(words_.reference)); });
    add_of_program("compare N [scene.rt] [options]",
                   "your picture, the reference's, the difference",
                   [this](Rest rest) { return rt::compare_pictures(comparison(words_, rest)); });
    add_of_program("explain N [ROW,COLUMN]", "your numbers for a pixel beside the reference's",
                   [this](Rest rest) { return explain(words_, rest); })
        ->add_flag("--all", words_.all, "every line that differs, not only the first");
    CLI::App* debug_command = add_of_stage(
        "debug N [CASE]", "start gdb or lldb at the call that fails",
        [this](Rest) { return rt::debug(stage(), words_.case_name, !words_.prepare); });
    debug_command
        ->add_option("CASE", words_.case_name,
                     "words of a case's name, in quotes; the first that fails if not given")
        ->type_name("");
    debug_command->add_flag("--prepare", words_.prepare,
                            "start none: VS Code does, by .vscode/launch.json");
    add_of_stage("view [N]", "your picture and the reference's in a browser, with a movable camera",
                 [this](Rest) { return view(stage()); });
    add_of_stage("solution N", "show the reference, once you have passed or at the second call",
                 [this](Rest) { return rt::show_solution(stage()); });
    add_of_stage("reset N", "copy the starter again; your files are kept beside", [this](Rest) {
        rt::reset(stage());
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
            return rt::book({.project = rt::project_folder,
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
            std::puts("Such as -R NAME, --rerun-failed; ctest --help lists them.");
            return 0;
        })
        ->prefix_command()
        ->set_help_flag();
}

void Commands::add_author_commands() {
    using Rest = const rt::Command&;
    add("update NEW", "install a newer hand-out, folder or archive; your files stay",
        [this](Rest) { return rt::update(words_.place); })
        ->add_option("NEW", words_.place, "the hand-out")
        ->required()
        ->type_name("");
    add("audit", "test that each stage is complete", [](Rest) {
        return rt::audit();
    })->group(authors);
    add("measure [STUDY…]",
        "measure speed against accuracy on this machine: docs/reference/accuracy.md", rt::measure)
        ->allow_extras()
        ->group(authors);
    // The grader answers --help.
    add("grade SUBMISSIONS… --out DIR", "grade in a sandbox; --help lists options", rt::run_grader)
        ->prefix_command()
        ->group(authors)
        ->set_help_flag();
    CLI::App* handout_command =
        add("handout DIR", "write a copy without the solutions, for students; or DIR.tar.gz",
            [this](Rest) { return rt::hand_out(words_.place, words_.also, words_.selection); });
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
            [this](const std::string& stages) { rt::select_stages(words_.selection, stages); },
            "those whose pages, hints and starters students get: 1-8")
        ->type_name("A-B");
    handout_command->add_option("--hints", words_.selection.hints, "levels of hints, 0 to 3")
        ->check(CLI::Range(0, rt::hint_levels).description(""))
        ->type_name("LEVELS");
    handout_command->add_flag_callback(
        "--without-answers", [this] { words_.selection.answers = false; },
        "without the answers to the pages' questions");
}

void Commands::print_summary() const {
    rt::show_progress();
    std::string names;
    for (const CLI::App* command : app_.get_subcommands({}))
        if (!is_missing(command->get_name()) && command->get_group() != authors)
            names += " " + command->get_name();
    std::printf("\n%s%s\n", rt::wrapped_page(rt::tr("Commands:") + names, 0).c_str(),
                rt::tr("./course --help describes them.").c_str());
    if (rt::is_handout(rt::project_folder))
        std::printf("\n%s\n", rt::wrapped(rt::read_manifest(rt::project_folder).title).c_str());
    std::puts("");
    rt::show_next();
}

void Commands::print_list() const {
    constexpr std::size_t column = 27;  // of the descriptions
    std::string group;
    for (const CLI::App* command : app_.get_subcommands({})) {
        if (is_missing(command->get_name())) continue;
        if (command->get_group() == authors && group != authors)
            std::printf("\n%s\n\n", rt::tr("For lecturers, and for authors of stages:").c_str());
        group = command->get_group();
        std::string line = command->get_description();
        const std::size_t end = line.find(": ");
        line.replace(end, 2, std::string(end + 2 < column ? column - end : 2, ' '));
        std::puts(rt::wrapped(line, rt::terminal_columns(), column).c_str());
    }
    const std::string notes = rt::tr(
        "N is {what}.\nrun, compare, explain: --mine uses all your stages, --reference 3,5 all but "
        "these. ./course --version prints the version.",
        {{"what", rt::tr(stage_option)}});
    std::fputs(("\n" + rt::wrapped_page(notes, 0)).c_str(), stdout);
}

std::vector<std::string> Commands::command_names() const {
    std::vector<std::string> names;
    for (const CLI::App* command : app_.get_subcommands({}))
        if (!is_missing(command->get_name())) names.push_back(command->get_name());
    return names;
}

void Commands::refuse(const CLI::ParseError& error, const std::string& first) const {
    const auto chosen = app_.get_subcommands();
    if (chosen.empty())
        throw rt::InputError({}, "no command \"" + first + "\": ./course lists the commands." +
                                     rt::suggestion(first, command_names()));
    const std::string name = chosen[0]->get_name();
    const std::vector<std::string> unexpected = app_.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr || unexpected.empty())
        throw rt::InputError({}, name + ": " + error.what());
    std::string words;
    std::vector<std::string> options;
    for (const std::string& word : unexpected) words += " " + word;
    for (const CLI::Option* option : chosen[0]->get_options())
        options.push_back(option->get_name());
    throw rt::InputError({}, name + ": not expected:" + words + "; ./course " + name +
                                 " --help lists the options." +
                                 rt::suggestion(unexpected[0], options));
}

int Commands::run(int argc, char** argv) {
    app_.parse_complete_callback([this] {
        if (!app_.got_subcommand("update")) rt::warn_of_half_update();
    });
    std::vector<const char*> words(argv, argv + argc);
    if (argc > 1 && words[1] == std::string_view("help")) {  // as "check --help"
        words.erase(words.begin() + 1);
        const std::vector<std::string> names = command_names();
        if (argc == 2 || std::find(names.begin(), names.end(), words[1]) != names.end())
            words.push_back("--help");
    }
    try {
        app_.parse(int(words.size()), words.data());
    } catch (const CLI::CallForHelp&) {
        if (app_.get_subcommands().empty())
            print_list();
        else
            std::cout << rt::wrapped_page(app_.help(), app_.get_formatter()->get_column_width());
        return 0;
    } catch (const CLI::ParseError& error) {
        refuse(error, words[1]);
    }
    if (app_.get_subcommands().empty()) print_summary();
    return status_;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file above the size limit is an error to report
    try {
        rt::read_project_translations("course");
        const int status = Commands().run(argc, argv);
        rt::finish_output();
        return status;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
    } catch (const rt::ProgramError& error) {
        std::cerr << error.what();
    } catch (const std::exception& error) {  // from the system: a folder of another user
        std::cerr << "error: " << error.what() << '\n';
    }
    return 2;
}
