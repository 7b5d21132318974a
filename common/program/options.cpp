#include "common/program/options.hpp"

#include "common/program/option_checks.hpp"
#include "common/program/shade_options.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/text.hpp"
#include "common/system/translated_help.hpp"
#include "common/system/version.hpp"
#include "common/system/wrap.hpp"
#include "common/tuning/choices.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <thread>

namespace rt {

namespace {

constexpr int most_threads = 1024;
constexpr int most_shapes = 1'000'000'000;
constexpr int camera_stage = 2;   // which brings its position and direction
constexpr int most_frames = 360;  // an animation is in memory until it is written
constexpr int most_cameras = 1'000'000;

constexpr double brightest = 255;  ///< in 8-bit levels
constexpr double least_error = 1e-3;
constexpr double least_time = 1e-3;  ///< seconds
constexpr double most_time = 1e6;

Resolution parse_size(const std::string& text) {
    const auto size = two_numbers(text, 'x');
    const auto fits = [](int side) { return 1 <= side && side <= largest_side; };
    if (!size || !std::all_of(size->begin(), size->end(), fits))
        throw InputError({}, "--size must be WIDTHxHEIGHT, each 1 to " +
                                 std::to_string(largest_side) + ", not " + rt::quoted(text));
    return {.width = (*size)[0], .height = (*size)[1]};
}

Pixel parse_pixel(const std::string& option, const std::string& text) {
    const auto pixel = two_numbers(text, ',');
    if (!pixel || (*pixel)[0] < 0 || (*pixel)[1] < 0)
        throw InputError({},
                         option + " must be ROW,COLUMN, counted from 0, not " + rt::quoted(text));
    return {.row = (*pixel)[0], .column = (*pixel)[1]};
}

/// Adds an option whose value is a decimal number from least to most; NaN is rejected.
template <class Use>
void add_number(CLI::App& app, const std::string& name, double least, double most,
                const std::string& help, const std::string& type, Use use) {
    app.add_option_function<std::string>(
           name,
           [=](const std::string& word) {
               const std::optional<double> value = whole_floating<double>(word);
               if (!value || !(least <= *value && *value <= most)) {
                   std::ostringstream range;
                   range << name << " must be a number from " << least << " to " << most << ", not "
                         << quoted(word);
                   throw InputError({}, range.str());
               }
               use(*value);
           },
           help)
        ->type_name(type);
}

/// Adds an option whose value is one of two words; the default is the first.
void add_choice(CLI::App& app, const std::string& name, bool& second,
                const std::array<std::string, 2>& words, const std::string& help) {
    app.add_option_function<std::string>(
           name, [&second, last = words[1]](const std::string& word) { second = word == last; },
           help + "; " + words[0] + " if not given")
        ->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())).description(""))
        ->type_name(words[0] + "|" + words[1]);
}

void add_precision(CLI::App& app, const Program& program, Precision& precision) {
    precision = program.exact ? Precision::exact : Precision::f64;
    app.add_option("--precision", precision,
                   "the type of numbers; double if not given; exact: every hit is that of exact "
                   "arithmetic, computed by the references, not by a student's file")
        ->transform(one_of<Precision>(
            {{"double", Precision::f64}, {"float", Precision::f32}, {"exact", Precision::exact}}))
        ->type_name("double|float|exact");
}

/// Throws InputError with the name of the right program, if this program does not have the
/// precision.
void check_precision(const Program& program, Precision precision) {
    if ((precision == Precision::exact) == program.exact) return;
    const std::string name(stage_name(program.stage));
    if (program.exact)
        throw InputError({}, "--precision float and double are another program: " + name);
    throw InputError({}, "--precision exact is another program, build/" + name +
                             "_exact: ninja -C build " + name + "_exact builds it, ./course run " +
                             std::to_string(program.stage) +
                             " --precision exact builds and runs it");
}

/// Adds the options for automatic settings, where there is something to choose for.
void add_goals(CLI::App& app, int stage, Options& options) {
    if (stage < shapes_stage) return;
    add_number(app, "--tolerance", least_error, brightest,
               "choose the cheapest settings with at most this error of a pixel, of 255: beside "
               "the mean of many rays, or of --samples N if given",
               "E", [&options](double levels) { options.tolerance = levels; });
    add_number(app, "--time", least_time, most_time,
               "choose the most accurate settings that take at most this many seconds", "S",
               [&options](double seconds) { options.time = seconds; });
}

void add_pixel_options(CLI::App& app, RenderSettings& settings) {
    app.add_option("--samples", settings.pixel_samples,
                   "number of rays through each pixel, whose color is their mean; 1 if not given: "
                   "the ray through its center")
        ->transform(whole_number(1, most_pixel_samples))
        ->type_name("N");
    add_number(app, "--pixel-error", least_error, brightest,
               formatted("trace more rays through a pixel only beside edges, until its estimated "
                         "error is below this, of 255; at most --samples, or %d if not given",
                         right_pixel_samples),
               "E", [&settings](double levels) { settings.pixel_error = levels; });
    app.add_option("--gamma", settings.gamma,
                   "write colors encoded for screens, or proportional to light; proportional, and "
                   "the file does not say so, if not given")
        ->transform(one_of<Gamma>({{"srgb", Gamma::srgb}, {"linear", Gamma::linear}}))
        ->type_name("srgb|linear");
}

void add_light_options(CLI::App& app, int stage, RenderSettings& settings) {
    const auto add_whole = [&app](const std::string& name, auto& value, const std::string& help,
                                  int least, int most) {
        return app.add_option(name, value, help)
            ->transform(whole_number(least, most))
            ->type_name("N");
    };
    if (stage >= light_stage)
        app.add_option("--term", settings.term, "show one of Phong's terms; their sum if not given")
            ->transform(one_of<PhongTerm>({{"ambient", PhongTerm::ambient},
                                           {"diffuse", PhongTerm::diffuse},
                                           {"specular", PhongTerm::specular}}))
            ->type_name("ambient|diffuse|specular");
    if (stage >= soft_shadow_stage) {
        add_whole(
            "--shadow-samples", settings.shadow_samples,
            "largest number of rays to a light with a size; 16 if not given; with --samples N, "
            "divided by √N",
            1, most_shadow_samples);
        add_number(
            app, "--shadow-error", least_error, brightest,
            "trace shadow rays until the estimated error of a light's part is below this, of "
            "255",
            "E", [&settings](double levels) { settings.shadow_error = levels; });
        add_whole("--shadow-agree", settings.shadow_agree,
                  "or until this many agree: all reach the light, or none; with --shadow-error", 1,
                  most_shadow_samples)
            ->needs("--shadow-error");
    }
    if (stage >= mirror_stage)
        add_whole("--depth", settings.depth,
                  "largest number of successive reflections; 8 if not given", 0, most_depth);
}

/// Adds the options of the files, and of the picture's size.
void add_files(CLI::App& app, const std::string& stage_name, Options& options) {
    app.add_option("scene", options.scene,
                   formatted("the scene; scenes/%s.rt if not given", stage_name.c_str()))
        ->type_name("FILE");
    app.add_option("-o,--output", options.output, "the picture; renders/<scene>.png if not given")
        ->type_name("PNG");
    app.add_option_function<std::string>(
           "--size", [&options](const std::string& text) { options.size = parse_size(text); },
           to_translate("the picture's size in pixels, in place of the scene's"))
        ->type_name("WIDTHxHEIGHT");
}

/// Adds the number of threads. In stage 1, one thread is the stage's own loop
/// (common/render/stage.hpp).
void add_threads(CLI::App& app, int stage, int& threads) {
    const bool own_loop = stage == 1;
    threads = own_loop ? 1 : std::max(1, int(std::thread::hardware_concurrency()));
    app.add_option("--threads", threads,
                   own_loop ? to_translate("one, the loop in main.cpp, if not given")
                            : to_translate("as many as there are cores if not given"))
        ->transform(whole_number(1, most_threads))
        ->type_name("N");
}

/// Adds the options that print the rays of one pixel.
void add_pixel_log(CLI::App& app, int stage, Options& options) {
    app.add_option_function<std::string>(
           "--pixel",
           [&options](const std::string& text) { options.pixel = parse_pixel("--pixel", text); },
           to_translate("print the log of one pixel's ray, and make no picture"))
        ->type_name("ROW,COLUMN");
    if (stage < shapes_stage) return;
    app.add_option_function<std::string>(
           "--rays",
           [&options](const std::string& text) { options.rays = parse_pixel("--rays", text); },
           to_translate("print the rays of one pixel and the outlines of the shapes as JSON, for "
                        "./course view, and make no picture"))
        ->type_name("ROW,COLUMN")
        ->excludes("--pixel");
}

void add_hierarchy(CLI::App& app, int stage, std::optional<std::size_t>& from) {
    if (stage < shapes_stage) return;
    app.add_option(
           "--hierarchy-from", from,
           "build a hierarchy from this many shapes of a kind on; 32 if not given, 8 for meshes")
        ->transform(whole_number(2, most_shapes))
        ->type_name("N");
}

/// Adds the options of how a scene is read, and of its camera.
void add_reading(CLI::App& app, Options& options, bool& is_horizontal) {
    SceneReading& reading = options.reading;
    add_choice(app, "--fov", is_horizontal, {"vertical", "horizontal"},
               "side of the picture that a scene's field of view spans");
    add_choice(app, "--cyl", reading.cylinder_from_base, {"center", "base"},
               "meaning of a cylinder's position");
    add_choice(app, "--hand", reading.axes.left_handed, {"right", "left"},
               "handedness of a scene's axes, where left exchanges left and right");
    add_choice(app, "--up", reading.axes.z_up, {"y", "z"}, "axis of the scene that points up");
    app.add_option("--camera", options.camera, "number of the scene's camera; 1 if not given")
        ->transform(whole_number(1, most_cameras))
        ->type_name("N");
    app.add_flag("--strict", reading.strict, "reject everything outside the format of scenes");
}

void add_turn(CLI::App& app, int stage, std::optional<int>& frames) {
    if (stage < camera_stage) return;
    CLI::Option* const turn =
        app.add_option("--turn", frames,
                       "make an animated PNG of N pictures: the camera goes around the middle "
                       "of all shapes")
            ->transform(whole_number(2, most_frames))
            ->type_name("N");
    for (const char* other : {"--pixel", "--requirements", "--preview"}) turn->excludes(other);
    if (stage < shapes_stage) return;
    for (const char* other : {"--tolerance", "--time", "--rays"}) turn->excludes(other);
}

/// The output of --pixel and --rays contains nothing else, and with them and --requirements no
/// picture is made.
void exclude_from_logs(CLI::App& app) {
    for (const char* log : {"--pixel", "--rays"})
        if (CLI::Option* const option = app.get_option_no_throw(log))
            for (const char* other :
                 {"--output", "--requirements", "--preview", "--tolerance", "--time"})
                if (CLI::Option* const excluded = app.get_option_no_throw(other))
                    option->excludes(excluded);
    app.get_option("--requirements")->excludes("--output");
}

/// The path of a file in the project's folder, relative to the working directory.
std::string in_project(const Program& program, const std::string& folder, const std::string& name) {
    const auto file = std::filesystem::path(program.root) / folder / name;
    std::error_code none;  // if the working directory no longer exists, the path stays as it is
    return file.lexically_proximate(std::filesystem::current_path(none)).string();
}

std::string default_scene(const Program& program) {
    return in_project(program, "scenes", name_of(program.stage) + ".rt");
}

std::string default_output(const Program& program, const std::string& scene) {
    return in_project(program, "renders", std::filesystem::path(scene).stem().string() + ".png");
}

/// Checks the options together, and sets what was not given.
void complete(const Program& program, const CLI::App& app, Options& options) {
    check_precision(program, options.precision);
    const auto is_given = [&app](const std::string& option) {
        const CLI::Option* const known = app.get_option_no_throw(option);
        return known != nullptr && !known->empty();
    };
    RenderSettings& settings = options.settings;
    if (is_given("--shadow-error") && !is_given("--shadow-samples"))
        settings.shadow_samples = most_shadow_samples;
    if (is_given("--pixel-error") && (options.tolerance || options.time))
        throw InputError({},
                         "--pixel-error must be given without --tolerance and --time, which "
                         "choose it");
    if (is_given("--pixel-error") && !is_given("--samples"))
        settings.pixel_samples = right_pixel_samples;
    check_shade_options(program.stage, options, is_given);
    options.precision_given = is_given("--precision");
    options.given = {.pixel_samples = is_given("--samples"),
                     .shadow_samples = is_given("--shadow-samples") || is_given("--shadow-error"),
                     .depth = is_given("--depth")};
    for (const char* file : {"scene", "--output"})
        if (is_given(file) && app.get_option(file)->as<std::string>().empty())
            throw InputError({}, std::string(file) + " must be the name of a file, not \"\"");
    if (options.scene.empty()) options.scene = default_scene(program);
    if (options.output.empty()) options.output = default_output(program, options.scene);
}

/// Throws InputError for words that CLI11 does not know, in the order in which they were typed.
[[noreturn]] void refuse_words(const CLI::App& app) {
    std::string words;
    for (const std::string& word : app.remaining()) words += " " + word;
    std::vector<std::string> options;
    for (const CLI::Option* option : app.get_options()) options.push_back(option->get_name());
    throw InputError({}, "not expected:" + words + " (--help lists the options)" +
                             suggestion(app.remaining()[0], options));
}

}  // namespace

std::optional<Options> parse_options(const Program& program, int argc, const char* const* argv) {
    const std::string name = name_of(program.stage);
    Options options;
    bool is_horizontal = false;
    CLI::App app{name + ": renders a .rt scene. docs/" + name + ".md is its page.", name};
    app.option_defaults()->take_last();
    app.set_version_flag("--version", name + ", Raysteps " + version(program.root),
                         "print the version and exit");
    add_files(app, name, options);
    add_precision(app, program, options.precision);
    add_pixel_options(app, options.settings);
    add_threads(app, program.stage, options.threads);
    add_pixel_log(app, program.stage, options);
    add_shade_options(app, program.stage, options);
    add_light_options(app, program.stage, options.settings);
    add_hierarchy(app, program.stage, options.hierarchy_from);
    add_goals(app, program.stage, options);
    add_reading(app, options, is_horizontal);
    app.add_flag("--requirements", options.requirements,
                 "print what the scene requires and what is omitted, and make no picture");
    app.add_flag("--preview", options.preview, "show the picture in the terminal too");
    app.add_flag("--quiet", options.quiet, "print errors only");
    add_turn(app, program.stage, options.turn);
    exclude_from_logs(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        app.description(tr_text(app.get_description()));
        translate_help(app);
        std::cout << wrapped_page(app.help(), app.get_formatter()->get_column_width());
        return std::nullopt;
    } catch (const CLI::CallForVersion& asked) {
        std::cout << asked.what() << '\n';
        return std::nullopt;
    } catch (const CLI::ExtrasError&) {
        refuse_words(app);
    } catch (const CLI::ParseError& error) {
        throw InputError({}, std::string(error.what()) + " (--help lists the options)");
    }
    if (is_horizontal) options.reading.fov_axis = FovAxis::horizontal;
    complete(program, app, options);
    return options;
}

}  // namespace rt
