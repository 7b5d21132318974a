// The command line of `./course`: CLI11 parses it.
#pragma once

#include "common/course/handout/selection.hpp"
#include "common/system/process.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rt {

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
    Selection selection;
    std::optional<int> level;
    bool check = false;
    int seconds = 60;
    bool all = false;
    bool sanitize = false;
    bool prepare = false;
    std::string case_name;
};

/// The group of the commands of lecturers and authors; the others are for students.
inline constexpr const char* authors = "For lecturers, and for authors of stages";

/// The stage of a number or a name, or without a text the current one. Throws InputError if it is
/// no stage of this copy of the project.
[[nodiscard]] int parse_stage(const std::string& text);

/// True if the words ask for the help of the stage's program.
[[nodiscard]] bool wants_help(const Command& rest);

/// Prints what the command itself does with its arguments.
void show_help(const CLI::App& command);

/// The commands. CLI11 parses their arguments, prints their help, and starts them.
class Commands {
public:
    Commands();

    int run(int argc, char** argv);

private:
    /// A command with the words that CLI11 leaves to it; returns the exit status.
    using Body = std::function<int(const Command& rest)>;

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

    CLI::App app_{"Raysteps: a ray tracer, step by step", "./course"};
    Words words_;
    int status_ = 0;
};

}  // namespace rt
