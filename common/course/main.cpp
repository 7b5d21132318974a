// The commands behind `./course`.
#include "common/course/build.hpp"
#include "common/course/process.hpp"

#include "common/input_error.hpp"
#include "common/stages.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <filesystem>
#include <iostream>
#include <thread>

namespace {

using Words = std::vector<std::string>;

const std::string build_folder = RAYSTEPS_BUILD;

constexpr const char* test_time_limit = "300";  // seconds; a loop without end is a failure

constexpr std::array<const char*, rt::stage_names.size()> brings = {
    "a ray through every pixel",
    "a camera that looks anywhere",
    "spheres, and the nearest of them",
    "planes, and a horizon",
    "triangles without cracks between them",
    "squares, and the Cornell box",
    "open cylinders",
    "open cones",
    "light: ambient, diffuse, specular",
    "shadows",
    "shadows of lights that have a size",
    "mirrors",
    "meshes of a million triangles",
};

/// Stage 13 is left out of a build without OpenMesh, which the script `course` installs for whoever
/// asks for that stage.
constexpr bool has_meshes = RAYSTEPS_MESHES;

int parse_stage(const std::string& text) {
    const std::optional<int> stage = rt::find_stage(text);
    if (!stage)
        throw rt::InputError(
            {}, "no stage \"" + text + "\": give a number 1 to 13 or a name like step05_triangle");
    if (*stage == rt::mesh_stage && !has_meshes)
        throw rt::InputError({}, std::string(rt::stage_name(*stage)) +
                                     " needs OpenMesh: libopenmesh-dev, or what your system "
                                     "calls it");
    return *stage;
}

int list() {
    for (int stage = 1; stage <= int(brings.size()); ++stage)
        std::printf("%4d  %-22s %s\n", stage, rt::stage_name(stage).data(),
                    brings[std::size_t(stage - 1)]);
    std::puts(
        "\n"
        "./course run STAGE [scene.rt] [options]    draw its scene, or yours; --help lists "
        "options\n"
        "./course test [STAGE] [options of ctest]   its suite, or every test\n"
        "\n"
        "STAGE is a number or a name: 5, triangle, step05_triangle.");
    return 0;
}

int run(const Words& words) {
    if (words.empty()) throw rt::InputError({}, "which stage? ./course run 5");
    const std::string name(rt::stage_name(parse_stage(words[0])));
    if (const int status = rt::build(build_folder, {name}); status != 0) return status;
    Words command = {build_folder + "/" + name};
    command.insert(command.end(), words.begin() + 1, words.end());
    return rt::run_process(command);
}

int test(Words words) {
    const std::string cores = std::to_string(std::max(1u, std::thread::hardware_concurrency()));
    Words command = {"ctest", "--test-dir", build_folder,   "-j",
                     cores,   "--timeout",  test_time_limit};
    command.insert(command.end(),
                   {"--output-on-failure", "--progress", "--no-label-summary", "--no-tests=error"});
    Words targets;
    if (!words.empty() && words[0].rfind('-', 0) != 0) {
        const std::string name(rt::stage_name(parse_stage(words[0])));
        words.erase(words.begin());
        targets = {name + "_test_float", name + "_test_double"};
        command.insert(command.end(), {"-L", "^" + name + "$"});
    }
    command.insert(command.end(), words.begin(), words.end());
    if (const int status = rt::build(build_folder, targets); status != 0) return status;
    const int status = rt::run_process(command);
    if (targets.empty() && !has_meshes)
        std::puts("step13_meshes was left out: ./course test 13 installs what it needs");
    std::puts(status == 0 ? "every test passed" : "not every test passed: see above");
    return status;
}

int run_command(int argc, char** argv) {
    CLI::App app{"Raysteps: a ray tracer in thirteen steps", "course"};
    // Words after a command are its own, options among them.
    CLI::App* run_app = app.add_subcommand("run", "draw a stage's scene")->prefix_command();
    CLI::App* test_app = app.add_subcommand("test", "a stage's suite")->prefix_command();
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return list();
    } catch (const CLI::ParseError&) {
        throw rt::InputError(
            {}, "no command \"" + std::string(argv[1]) + "\": ./course lists the commands");
    }
    if (run_app->parsed()) return run(run_app->remaining());
    if (test_app->parsed()) return test(test_app->remaining());
    return list();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_command(argc, argv);
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
