// The commands behind `./course`.
#include "common/course/authoring/audit.hpp"
#include "common/course/authoring/measure.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/compiler_errors.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/check.hpp"
#include "common/course/exercise/compare.hpp"
#include "common/course/exercise/hints.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/course/handout/handout.hpp"
#include "common/course/handout/manifest.hpp"
#include "common/course/handout/update.hpp"
#include "common/course/view/view.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/paint.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <thread>

namespace {

constexpr const char* test_time_limit = "300";  // seconds; an endless loop is a failure

constexpr std::array<const char*, rt::stage_names.size()> brings = {
    "a ray through every pixel",
    "a camera in any direction",
    "spheres, and the closest of them",
    "planes, and a horizon",
    "triangles without cracks between them",
    "squares, and the Cornell box",
    "open cylinders",
    "open cones",
    "light: ambient, diffuse, specular",
    "shadows",
    "soft shadows of area lights",
    "mirrors",
    "meshes of a million triangles",
};

constexpr const char* commands = R"(
./course start N           create your own file: steps/stepNN_…/student/
./course check N           test it, explain the first failure, compare the pictures
./course watch N           check again whenever you save
./course hint N            show the next of three hints
./course run N [scene.rt] [options]     render its scene, or yours; --help lists options
./course compare N [scene.rt] [options] your picture, the reference's, the difference
./course explain N [ROW,COLUMN]         your numbers for a pixel beside the reference's
./course view [N]          your picture and the reference's in a browser, with a movable camera
./course solution N        show the reference, once you have passed or at the second call
./course reset N           copy the starter again; your files are kept beside
./course test [N] [options of ctest]    run the stage's suite, or all tests
./course update NEW        install a newer hand-out, folder or archive; your files stay
./course audit             for authors of stages: test that each one is complete
./course measure [STUDY…]  measure speed against accuracy on this machine: docs/reference/accuracy.md
./course grade SUBMISSIONS… --out DIR   for instructors: grade in a sandbox; --help lists options
./course handout DIR       for instructors: a copy without the solutions; or DIR.tar.gz

N is a number or a name: 5, triangle, step05_triangle; the default is your current stage.
run, compare, explain: --mine uses all your stages, --reference 3,5 all but these.)";

/// The arguments of a command.
struct Words {
    std::string stage;
    std::vector<std::string> rest;
    bool mine = false;
    std::string reference;
};

int parse_stage(const std::string& text) {
    const std::optional<int> stage = text.empty() ? rt::current_stage() : rt::find_stage(text);
    if (!stage)
        throw rt::InputError(
            {}, "no stage \"" + text + "\": give a number 1 to 13 or a name like step05_triangle");
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

/// Prints the student's progress: thirteen lines.
int list() {
    const int current = rt::current_stage();
    for (int stage = 1; stage <= int(brings.size()); ++stage) {
        const rt::Workbook workbook(stage);
        const char* mark = stage == current ? "▸" : " ";
        if (workbook.state() == rt::State::done) mark = "✓";
        std::string line = std::string(mark) + (stage < 10 ? "  " : " ") + std::to_string(stage) +
                           "  " + std::string(rt::stage_name(stage));
        line.resize(line.size() + 24 - rt::stage_name(stage).size(), ' ');
        line += workbook.state() == rt::State::untouched ? brings[std::size_t(stage - 1)]
                                                         : workbook.summary();
        std::puts(workbook.state() == rt::State::done ? rt::styled(line, rt::Style::good).c_str()
                  : stage == current                  ? rt::styled(line, rt::Style::bold).c_str()
                                                      : line.c_str());
    }
    const bool started = rt::Workbook(current).state() == rt::State::started;
    std::printf("\nNext: ./course %s %d, and read docs/%s.md\n", started ? "check" : "start",
                current, rt::stage_name(current).data());
    std::puts(commands);
    return 0;
}

int start(int stage) {
    rt::Workbook(stage).start();
    std::printf(
        "yours to write: %s\nread:           docs/%s.md\nthen:           ./course check %d\n",
        rt::Workbook(stage).files().front().lexically_relative(rt::project_folder).c_str(),
        rt::stage_name(stage).data(), stage);
    return 0;
}

int reset(int stage) {
    std::printf("your old files are kept in %s\n", rt::Workbook(stage).reset().c_str());
    return 0;
}

int hint(int stage) {
    rt::Workbook workbook(stage);
    rt::Record record = workbook.record();
    record.hints = std::min(record.hints + 1, rt::hint_levels);
    std::printf("%s, hint %d of %d\n\n%s", rt::stage_name(stage).data(), record.hints,
                rt::hint_levels, rt::hint_text(stage, record.hints).c_str());
    workbook.remember(record);
    return 0;
}

int solution(int stage) {
    const auto files = rt::files_in(rt::project_folder / rt::step_path(stage, "reference"), ".cpp");
    if (files.empty()) throw rt::InputError({}, "the solutions are not part of this hand-out");
    rt::Workbook workbook(stage);
    rt::Record record = workbook.record();
    ++record.solution_asked;
    workbook.remember(record);
    if (workbook.state() != rt::State::done && record.solution_asked < 2) {
        std::printf(
            "%s does not pass yet. ./course hint %d helps; repeat the command for the solution.\n",
            rt::stage_name(stage).data(), stage);
        return 1;
    }
    for (const auto& file : files)
        std::printf("// %s\n%s", file.lexically_relative(rt::project_folder).c_str(),
                    rt::read_text(file).c_str());
    return 0;
}

/// Builds a program of all the student's stages. If another stage does not compile, prints how to
/// build without it.
void build_all_mine(int stage) {
    try {
        rt::build({rt::stage_target(stage)});
    } catch (const rt::ProgramError& error) {
        const std::string text = error.what();
        for (int other = 1; other < stage; ++other)
            if (text.find(rt::step_path(other, "student/")) == 0)
                throw rt::ProgramError(text + "Without that stage: --reference " +
                                       std::to_string(other) + "\n");
        throw;
    }
}

/// True for the option that selects the exact precision, which has a program of its own.
bool wants_exact(const std::vector<std::string>& words) {
    const auto name = std::find(words.begin(), words.end(), "--precision");
    return std::find(words.begin(), words.end(), "--precision=exact") != words.end() ||
           (words.end() - name >= 2 && name[1] == "exact");
}

int run(int stage, const Words& words) {
    rt::choose_reference(parse_stages(words.reference));
    std::string name = rt::stage_target(stage);
    if (wants_exact(words.rest)) {
        if (rt::is_handout(rt::project_folder))
            throw rt::InputError({}, "--precision exact is not part of this hand-out");
        name = rt::stage_target(stage, "_exact");
        rt::build({name});
    } else {
        build_all_mine(stage);
    }
    rt::Command command = {(rt::build_folder / name).string()};
    command.insert(command.end(), words.rest.begin(), words.rest.end());
    return rt::run_process(command);
}

rt::ComparisonRequest contest(int stage, const Words& words) {
    rt::choose_reference(parse_stages(words.reference));
    return {
        .stage = stage, .all_mine = words.mine || !words.reference.empty(), .words = words.rest};
}

/// "ROW,COLUMN"
bool is_pixel(const std::string& word) {
    int row = 0;
    int column = 0;
    char rest = 0;
    return std::sscanf(word.c_str(), "%d,%d%c", &row, &column, &rest) == 2;
}

int explain(int stage, Words words) {
    std::string which;
    const auto word = std::find_if(words.rest.begin(), words.rest.end(), is_pixel);
    if (word != words.rest.end()) {
        which = *word;
        words.rest.erase(word);
    }
    return rt::explain_pixel(contest(stage, words), which);
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

int test(std::vector<std::string> words) {
    const std::string cores = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
    rt::Command command = {"ctest",     "--test-dir",   rt::build_folder.string(), "-j", cores,
                           "--timeout", test_time_limit};
    command.insert(command.end(),
                   {"--output-on-failure", "--progress", "--no-label-summary", "--no-tests=error"});
    std::vector<std::string> targets;
    if (!words.empty() && words[0].rfind('-', 0) != 0) {
        const std::string name = rt::stage_target(parse_stage(words[0]));
        words.erase(words.begin());
        targets = {name + "_test_float", name + "_test_double"};
        command.insert(command.end(), {"-L", "^" + name + "$"});
    }
    command.insert(command.end(), words.begin(), words.end());
    rt::choose_reference("");
    rt::build(targets);
    const int status = rt::run_process(command);
    if (targets.empty() && !rt::has_meshes)
        std::puts("step13_meshes was left out: ./course test 13 installs OpenMesh");
    std::puts(status == 0 ? "every test passed" : "not every test passed: see above");
    return status;
}

/// The grader is a separate program, which students do not get.
int grade(const std::vector<std::string>& words) {
    const bool attacks = std::find(words.begin(), words.end(), "--self-test") != words.end();
    rt::choose_reference("all");
    if (attacks)
        rt::build({"grading", "seal_test", "attacks_test"});
    else
        rt::build({"grading"});
    rt::Command command = {(rt::build_folder / "grade").string()};
    command.insert(command.end(), words.begin(), words.end());
    return rt::run_process(command);
}

int run_command(int argc, char** argv) {
    CLI::App app{"Raysteps: a ray tracer in thirteen steps", "course"};
    app.require_subcommand(0, 1);
    // Arguments after `test`, also options, belong to the command.
    CLI::App* test_app = app.add_subcommand("test")->prefix_command();
    CLI::App* audit_app = app.add_subcommand("audit");
    CLI::App* grade_app = app.add_subcommand("grade")->prefix_command();
    grade_app->set_help_flag();  // it is the grader's to answer
    CLI::App* measure_app = app.add_subcommand("measure")->allow_extras();
    std::string place;
    for (const char* name : {"handout", "update"})
        app.add_subcommand(name)->add_option("place", place)->required();
    Words words;
    for (const char* name : {"start", "check", "watch", "hint", "solution", "reset", "view"})
        app.add_subcommand(name)->add_option("stage", words.stage);
    for (const char* name : {"run", "compare", "explain"}) {
        CLI::App* command = app.add_subcommand(name)->allow_extras();
        command->set_help_flag();  // it is the program's to answer
        command->add_option("stage", words.stage);
        command->add_flag("--mine", words.mine);
        command->add_option("--reference", words.reference);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return list();
    } catch (const CLI::ParseError& error) {
        const auto chosen = app.get_subcommands();
        throw rt::InputError({}, chosen.empty() ? "no command \"" + std::string(argv[1]) +
                                                      "\": ./course lists the commands"
                                                : chosen[0]->get_name() + ": " + error.what());
    }
    if (!app.got_subcommand("update")) rt::warn_of_half_update();
    if (test_app->parsed()) return test(test_app->remaining());
    if (grade_app->parsed()) return grade(grade_app->remaining());
    if (measure_app->parsed()) return rt::measure(measure_app->remaining());
    if (audit_app->parsed()) return rt::audit();
    if (app.get_subcommands().empty()) return list();
    CLI::App* command = app.get_subcommands()[0];
    const std::string name = command->get_name();
    if (name == "handout") return rt::hand_out(place);
    if (name == "update") return rt::update(place);
    words.rest = command->remaining();
    const int stage = parse_stage(words.stage);
    if (name == "start") return start(stage);
    if (name == "check") return rt::check(stage);
    if (name == "watch") rt::watch(stage);
    if (name == "hint") return hint(stage);
    if (name == "solution") return solution(stage);
    if (name == "reset") return reset(stage);
    if (name == "view") return view(stage);
    if (name == "run") return run(stage, words);
    if (name == "compare") return rt::compare_pictures(contest(stage, words));
    return explain(stage, words);
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file above the size limit is an error to report
    try {
        const int status = run_command(argc, argv);
        rt::finish_output();
        return status;
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
    } catch (const rt::ProgramError& error) {
        std::cerr << error.what();
        // from the system: a folder of another user, for example
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
    }
    return 2;
}
