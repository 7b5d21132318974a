// `./course grade`: the grader's program.
#include "common/course/grade/grade.hpp"
#include "common/course/grade/reports/reports.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translated_help.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <CLI/CLI.hpp>

#include <sys/stat.h>

#include <csignal>
#include <iostream>
#include <optional>
#include <thread>

namespace {

namespace fs = std::filesystem;
using rt::grade::Order;

/// The stages of "1-5,mirror", if the option is given more than once all of them.
std::set<int> parse_stages(const std::vector<std::string>& words) {
    std::set<int> stages;
    for (const std::string& word : words) {
        const auto found = rt::find_stages(word);
        if (!found) throw rt::InputError({}, "no stage \"" + word + "\"");
        stages.insert(found->begin(), found->end());
    }
    return stages;
}

/// "2/8": the second of eight parts of a class.
void parse_part(const std::string& word, Order& order) {
    const auto part = rt::two_numbers(word, '/');
    if (!part || (*part)[0] < 1 || (*part)[0] > (*part)[1])
        throw rt::InputError({}, "--part needs K/N, such as 1/8 to 8/8, not \"" + word + "\"");
    order.part = (*part)[0];
    order.parts = (*part)[1];
}

/// The seal, attacked.
int self_test(const fs::path& build) {
    const int seal = rt::run_process({build / "seal_test"});
    const int attacks = rt::run_process({build / "attacks_test"});
    return seal == 0 && attacks == 0 ? 0 : 1;
}

/// The options that are not the order's own, or not in its form.
struct Command {
    Order order{.project = RAYSTEPS_ROOT, .build = RAYSTEPS_BUILD};
    std::vector<std::string> stages;
    std::string part;
    std::vector<std::string> students;
    fs::path gradescope;
    std::string elsewhere;
    bool report = false;
    bool attack = false;
};

/// Nothing if only the help was wanted, which it prints.
std::optional<Command> parse(int count, char** words) {
    CLI::App app{rt::to_translate("Grades submissions: folders, archives, or folders of these"),
                 "course grade"};
    Command command;
    Order& order = command.order;
    // One more than the number of cores: one job may wait for code that sleeps.
    order.jobs = 1 + int(std::max(1u, std::thread::hardware_concurrency()));
    app.add_option("submissions", order.places);
    app.add_option("--out", order.results,
                   "folder of the results; an interrupted run is continued");
    app.add_option("--seed-file", order.seed_file,
                   "file with 16 hexadecimal digits: the seed of the inputs; else it is random");
    app.add_option("--stages", command.stages, "1-5,mirror: only these stages");
    app.add_option("--jobs", order.jobs, "number of submissions graded at a time")
        ->check(CLI::Range(1, 256));
    app.add_option("--part", command.part,
                   "K/N: this part of the class, for N machines that share a folder");
    app.add_option("--student", command.students,
                   "anna,ben: grade only these students of the class")
        ->delimiter(',');
    CLI::Option* one =
        app.add_flag("--one", order.one, "the places are one student's submission, not a class");
    app.add_flag("--class", order.is_class,
                 "an archive is a class, as platforms pack one, not one student's submission")
        ->excludes(one);
    app.add_option("--gradescope", command.gradescope,
                   "write this results.json for one student's submission");
    app.add_option(
        "--for", command.elsewhere,
        "gradescope, github or slurm: write the files for grading there into the given folder");
    app.add_flag("--report", command.report, "only write the reports of the existing marks");
    app.add_flag("--self-test", command.attack, "attack the sandbox, to test it on this machine");
    try {
        app.parse(count, words);
    } catch (const CLI::CallForHelp&) {
        app.description(rt::tr(app.get_description()));
        rt::translate_help(app);
        std::cout << rt::wrapped_page(app.help(), app.get_formatter()->get_column_width());
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw rt::InputError({}, std::string("grade: ") + error.what());
    }
    order.stages = parse_stages(command.stages);
    if (!command.part.empty()) parse_part(command.part, order);
    order.students = {command.students.begin(), command.students.end()};
    order.one = order.one || !command.gradescope.empty();
    return command;
}

int grade_class(const Order& order, const fs::path& gradescope) {
    const rt::grade::Outcome outcome = rt::grade::grade(order);
    if (outcome == rt::grade::Outcome::interrupted) {
        std::cerr << rt::tr("interrupted: the same command continues from here") << '\n';
        return 1;
    }
    const int status = outcome == rt::grade::Outcome::failed ? 2 : 0;
    if (order.parts > 1) return status;  // --report follows when all parts are there
    rt::grade::write_reports(order.results, order.project, gradescope);
    std::cout << (order.results / "grades.csv").string() << '\n'
              << (order.results / "class.html").string() << '\n';
    return status;
}

int carry_out(const Command& command) {
    const Order& order = command.order;
    if (command.attack) return self_test(order.build);
    if (!command.elsewhere.empty()) {
        if (order.places.size() != 1) throw rt::InputError({}, "grade: --for needs one folder");
        rt::grade::write_for(command.elsewhere, order.places[0], order.project, order.stages);
        return 0;
    }
    if (order.results.empty()) throw rt::InputError({}, "grade: --out DIR is missing");
    umask(S_IRWXG | S_IRWXO);  // results are the lecturer's alone
    if (command.report) {
        rt::grade::write_reports(order.results, order.project);
        return 0;
    }
    if (order.places.empty()) throw rt::InputError({}, "grade: no submissions given");
    if (!command.gradescope.empty()) rt::grade::check_gradescope_file(command.gradescope);
    return grade_class(order, command.gradescope);
}

}  // namespace

int main(int count, char** words) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file above the size limit is an error to report
    try {
        rt::grade::read_terminal_language(RAYSTEPS_ROOT);
        const std::optional<Command> command = parse(count, words);
        const int status = command ? carry_out(*command) : 0;
        rt::finish_output();
        return status;
    } catch (const rt::InputError& error) {
        std::cerr << rt::tr_text(error.what()) << '\n';
    } catch (const rt::ProgramError& error) {
        std::cerr << rt::tr_lines(error.what());
    } catch (const std::exception& error) {
        std::cerr << rt::tr_text("error: " + rt::one_line(error.what())) << '\n';
    }
    return 2;
}
