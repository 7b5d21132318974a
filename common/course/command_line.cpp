#include "common/course/command_line.hpp"

#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/commands.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/course/handout/handout.hpp"
#include "common/system/input_error.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translated_help.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>

namespace rt {

namespace {

constexpr const char* stage_option = to_translate(
    "a number or a name: 5, triangle, step05_triangle; the default is your current stage");

/// "triangle" and "step05_triangle", for each stage.
std::vector<std::string> stage_words() {
    std::vector<std::string> words;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        words.push_back(topic_of(stage));
        words.push_back(name_of(stage));
    }
    return words;
}

/// " Did you mean check?"
std::string suggested(const std::string& word, const std::vector<std::string>& known) {
    const std::string sentence = suggestion(word, known);
    return sentence.empty() ? "" : " " + tr_text(sentence.substr(1));
}

/// True for a command that only a clone has and this is a hand-out, or the other way round.
bool is_missing(const std::string& command) {
    constexpr std::array<std::string_view, 5> of_clones = {"solution", "audit", "measure", "grade",
                                                           "handout"};
    if (!is_handout(project_folder)) return command == "update";
    return std::ranges::find(of_clones, command) != of_clones.end();
}

}  // namespace

int parse_stage(const std::string& text) {
    const std::optional<int> stage = text.empty() ? current_stage() : find_stage(text);
    if (!stage)
        throw InputError({}, tr("no stage \"{word}\": give a number 1 to {last} or a name like "
                                "step05_triangle.",
                                {{"word", text}, {"last", stage_names.size()}}) +
                                 suggested(text, stage_words()));
    const Values values = {{"stage", name_of(*stage)}};
    if (!is_here(*stage)) throw InputError({}, tr("{stage} is not part of this hand-out", values));
    if (*stage >= mesh_stage && !has_meshes)
        throw InputError({},
                         tr("{stage} needs OpenMesh: libopenmesh-dev, or what your system calls "
                            "it",
                            values));
    return *stage;
}

bool wants_help(const Command& rest) {
    return std::ranges::any_of(
        rest, [](const std::string& word) { return word == "--help" || word == "-h"; });
}

void show_help(const CLI::App& command) {
    constexpr std::size_t column = 21;  // of the descriptions
    std::string page = command.get_description() + "\n\n";
    for (const CLI::Option* option : command.get_options()) {
        std::string line = "  " + option->get_name() + " " + option->get_type_name();
        line.resize(std::max(line.size() + 1, column), ' ');
        page += line + option->get_description() + "\n";
    }
    print(wrapped_page(page, column));
}

Commands::Commands() {
    app_.require_subcommand(0, 1);
    add_student_commands();
    add_author_commands();
    translate_help(app_);
    for (CLI::App* command : app_.get_subcommands({})) translate_help(*command);
}

CLI::App* Commands::add(const std::string& usage, const std::string& description,
                        const Body& body) {
    const std::size_t end = std::min(usage.find(' '), usage.size());
    const std::string name = usage.substr(0, end);
    const std::string words = end < usage.size() ? " " + tr(usage.substr(end + 1)) : "";
    CLI::App* command =
        app_.add_subcommand(name, "./course " + name + words + ": " + tr(description));
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
    const auto answer = [this, body](const Command& rest) {
        if (!wants_help(rest)) return body(rest);
        const CLI::App& command = *app_.get_subcommands()[0];
        show_help(command);
        const bool is_run = command.get_name() == "run";  // which builds the program
        print_line((is_run ? tr("The other options are those of the stage's program:") + "\n"
                           : tr("The other options are those of the stage's program: ./course run "
                                "{stage} --help lists them.",
                                {{"stage", stage()}})));
        if (!is_run) return 0;
        std::fflush(stdout);
        return run_stage(stage(), {"--help"}, "");
    };
    CLI::App* command = add_of_stage(usage, description, answer)->allow_extras();
    command->set_help_flag();
    command->add_flag("--mine", words_.mine, "use all your stages");
    command->add_option("--reference", words_.reference, "use all your stages but these: 3,5")
        ->type_name("N,N");
    return command;
}

void Commands::print_summary() const {
    show_progress();
    std::string names;
    for (const CLI::App* command : app_.get_subcommands({}))
        if (!is_missing(command->get_name()) && command->get_group() != authors)
            names += " " + command->get_name();
    print("\n" + wrapped_page(tr("Commands:") + names, 0));
    print_line(tr("./course --help describes them."));
    if (is_handout(project_folder))
        print_line("\n" + wrapped(tr_text(read_manifest(project_folder).title)));
    print_line("");
    show_next();
}

void Commands::print_list() const {
    constexpr std::size_t column = 27;  // of the descriptions
    std::string group;
    for (const CLI::App* command : app_.get_subcommands({})) {
        if (is_missing(command->get_name())) continue;
        if (command->get_group() == authors && group != authors)
            print_line("\n" + tr("For lecturers, and for authors of stages:") + "\n");
        group = command->get_group();
        std::string line = command->get_description();
        const std::size_t end = line.find(": ");
        line.replace(end, 2, std::string(end + 2 < column ? column - end : 2, ' '));
        print_line(wrapped(line, terminal_columns(), column));
    }
    const std::string notes = tr(
        "N is {what}.\nrun, compare, explain: --mine uses all your stages, --reference 3,5 all but "
        "these. ./course --version prints the version; --lang fr before a command answers in "
        "French.",
        {{"what", tr(stage_option)}});
    print(("\n" + wrapped_page(notes, 0)));
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
        throw InputError(
            {}, tr("no command \"{word}\": ./course lists the commands.", {{"word", first}}) +
                    suggested(first, command_names()));
    const std::string name = chosen[0]->get_name();
    const std::vector<std::string> unexpected = app_.remaining(true);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr || unexpected.empty())
        throw InputError(
            {}, tr("{command}: {what}", {{"command", name}, {"what", tr_text(error.what())}}));
    std::string words;
    std::vector<std::string> options;
    for (const std::string& word : unexpected) words += " " + word;
    for (const CLI::Option* option : chosen[0]->get_options())
        options.push_back(option->get_name());
    throw InputError({}, tr("{command}: not expected:{words}; ./course {command} --help lists the "
                            "options.",
                            {{"command", name}, {"words", words}}) +
                             suggested(unexpected[0], options));
}

int Commands::run(int argc, char** argv) {
    app_.parse_complete_callback([this] {
        if (!app_.got_subcommand("update")) warn_of_half_update();
    });
    std::vector<const char*> words(argv, argv + argc);
    if (argc > 1 && words[1] == std::string_view("help")) {  // as "check --help"
        words.erase(words.begin() + 1);
        const std::vector<std::string> names = command_names();
        if (argc == 2 || std::ranges::find(names, words[1]) != names.end())
            words.push_back("--help");
    }
    try {
        app_.parse(int(words.size()), words.data());
    } catch (const CLI::CallForHelp&) {
        if (app_.get_subcommands().empty())
            print_list();
        else
            std::cout << wrapped_page(app_.help(), app_.get_formatter()->get_column_width());
        return 0;
    } catch (const CLI::ParseError& error) {
        refuse(error, words[1]);
    }
    if (app_.get_subcommands().empty()) print_summary();
    return status_;
}

}  // namespace rt
