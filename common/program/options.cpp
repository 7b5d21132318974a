#include "common/program/options.hpp"

#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parse_floating.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string_view>
#include <thread>

namespace rt {

namespace {

constexpr int max_threads = 1024;
constexpr int most_shapes = 1'000'000'000;
constexpr int camera_stage = 2;   // which brings its position and direction
constexpr int most_frames = 360;  // an animation is in memory until it is written
constexpr int max_cameras = 1'000'000;

constexpr double brightest = 255;  ///< in 8-bit levels
constexpr double least_shown = 1e-30;
constexpr double most_shown = 1e30;
constexpr double least_error = 1e-3;
constexpr double least_time = 1e-3;  ///< seconds
constexpr double most_time = 1e6;

/// Parses two integers with `separator` between them and nothing around them.
std::optional<std::array<int, 2>> two_numbers(const std::string& text, char separator) {
    std::array<int, 2> numbers{};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, numbers[0]);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != separator) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, numbers[1]);
    if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
    return numbers;
}

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

/// Adds an option whose value is a number from least to most; NaN is rejected.
template <class Use>
void add_number(CLI::App& app, const std::string& name, double least, double most,
                const std::string& help, const std::string& type, Use use) {
    app.add_option_function<double>(
           name,
           [=](double value) {
               if (!(least <= value && value <= most)) {
                   std::ostringstream range;
                   range << name << " must be a number from " << least << " to " << most;
                   throw InputError({}, range.str());
               }
               use(value);
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
    const std::map<std::string, Precision> words = {
        {"double", Precision::f64}, {"float", Precision::f32}, {"exact", Precision::exact}};
    precision = program.exact ? Precision::exact : Precision::f64;
    app.add_option("--precision", precision,
                   "the type of numbers; double if not given; exact: every hit is that of exact "
                   "arithmetic, computed by the references, not by a student's file")
        ->transform(CLI::CheckedTransformer(words).description(""))
        ->type_name("double|float|exact");
}

/// Throws InputError with the name of the right program, if this program does not have the
/// precision.
void check_precision(const Program& program, Precision precision) {
    if ((precision == Precision::exact) == program.exact) return;
    const std::string name(stage_name(program.stage));
    if (program.exact)
        throw InputError({}, "--precision float and double are another program: " + name);
    throw InputError({}, "--precision exact is another program: ninja -C build " + name +
                             "_exact builds it, ./course run " + std::to_string(program.stage) +
                             " --precision exact builds and runs it");
}

/// Adds the options for automatic settings.
void add_goals(CLI::App& app, Options& options) {
    add_number(app, "--tolerance", least_error, brightest,
               "choose the cheapest settings with at most this error of a pixel, of 255: beside "
               "the mean of "
               "many rays, or of --samples N if given",
               "E", [&options](double steps) { options.tolerance = steps; });
    add_number(app, "--time", least_time, most_time,
               "choose the most accurate settings that take at most this many seconds", "S",
               [&options](double seconds) { options.time = seconds; });
}

/// Adds the options of the pixels.
void add_pixel_options(CLI::App& app, RenderSettings& settings) {
    app.add_option("--samples", settings.pixel_samples,
                   "number of rays through each pixel, whose color is their mean; 1 if not given: "
                   "the ray through its center")
        ->check(CLI::Range(1, most_pixel_samples).description(""))
        ->type_name("N");
    add_number(app, "--pixel-error", least_error, brightest,
               "trace more rays through a pixel only beside edges, until its estimated error is "
               "below this, of 255; at most --samples, or 1024 if not given",
               "E", [&settings](double steps) { settings.pixel_error = steps; });
    app.add_option("--gamma", settings.gamma,
                   "write colors encoded for screens, or proportional to light; proportional, and "
                   "the file does not say so, if not given")
        ->transform(CLI::CheckedTransformer(std::map<std::string, Gamma>{{"srgb", Gamma::srgb},
                                                                         {"linear", Gamma::linear}})
                        .description(""))
        ->type_name("srgb|linear");
}

/// The shadings that a stage's program has, the default first.
std::vector<Shading> shadings(int stage) {
    std::vector<Shading> all = {Shading::color};
    if (stage >= shapes_stage)
        all.insert(all.end(), {Shading::normal, Shading::depth, Shading::id, Shading::t});
    if (stage >= mirror_stage) all.push_back(Shading::bounces);
    all.push_back(Shading::samples);
    if (stage >= shapes_stage) all.push_back(Shading::cost);
    return all;
}

std::array<double, 2> parse_range(const std::string& text) {
    std::array<double, 2> ends{};
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto is_number = [](std::string_view part, double& number) {
        const auto [end, error] = parse_floating(part, number);
        return error == std::errc() && end == part.data() + part.size();
    };
    const std::string_view low = std::string_view(text).substr(0, comma);
    const std::string_view high = std::string_view(text).substr(std::min(comma + 1, text.size()));
    if (!is_number(low, ends[0]) || !is_number(high, ends[1]) ||
        !(least_shown <= ends[0] && ends[0] < ends[1] && ends[1] <= most_shown))
        throw InputError({},
                         "--shade-range must be two numbers LOW,HIGH with 1e-30 <= LOW < HIGH <= "
                         "1e30, not " +
                             rt::quoted(text));
    return ends;
}

/// Adds the options of what a pixel shows.
void add_shades(CLI::App& app, int stage, Options& options) {
    const std::vector<Shading> all = shadings(stage);
    std::vector<std::string> words;
    std::string list;
    for (const Shading shading : all) {
        words.push_back(shade_word(stage, shading));
        list += (list.empty() ? "" : "|") + words.back();
    }
    const std::string shapes =
        stage < shapes_stage
            ? ""
            : "abs(normal), or by a number, whose legend is printed: the distance to the hit, the "
              "shape, t, " +
                  std::string(stage >= mirror_stage ? "reflections, " : "") +
                  "intersection tests, or ";
    const std::string by = stage >= light_stage    ? "the scene's lights, "
                           : stage >= shapes_stage ? "a torch at the eye, "
                                                   : "direction (torch), or by ";
    app.add_option_function<std::string>(
           "--shade",
           [&options, all, stage](const std::string& word) {
               for (const Shading shading : all)
                   if (shade_word(stage, shading) == word) options.settings.shading = shading;
           },
           "color by " + by + shapes + "the rays of --pixel-error; " + words.front() +
               " if not given")
        ->check(CLI::IsMember(words).description(""))
        ->type_name(list);
    app.add_option_function<std::string>(
           "--shade-range",
           [&options](const std::string& text) { options.shade_range = parse_range(text); },
           "the ends of the scale of " +
               std::string(stage >= shapes_stage ? "--shade depth, t, samples and cost"
                                                 : "--shade samples") +
               "; the picture's smallest and largest number if not given")
        ->type_name("LOW,HIGH");
}

/// Throws InputError for options that have no meaning together with a picture of numbers.
template <class IsGiven>
void check_shade(int stage, const Options& options, const IsGiven& is_given) {
    const Shading shading = options.settings.shading;
    const bool has_scale =
        shows_number(shading) && shading != Shading::id && shading != Shading::bounces;
    if (options.shade_range && !has_scale)
        throw InputError({},
                         "--shade-range must be given with a --shade that has a scale of "
                         "numbers (--help lists them)");
    if (!shows_number(shading)) return;
    const std::string shade = "--shade " + shade_word(stage, shading);
    const bool counts_samples = shading == Shading::samples;
    if (counts_samples && !is_given("--pixel-error") && options.makes_picture())
        throw InputError({}, shade +
                                 " shows where --pixel-error traces more rays, and must be "
                                 "given with it");
    for (const char* other : {"--tolerance", "--time", "--turn"})
        if (is_given(other)) throw InputError({}, shade + " must be given without " + other);
    for (const char* other : {"--samples", "--pixel-error", "--gamma"})
        if (!counts_samples && is_given(other))
            throw InputError({}, shade +
                                     " shows a number of the ray through each pixel's center, "
                                     "and must be given without " +
                                     other);
}

/// Adds the options of the stages with light.
void add_light_options(CLI::App& app, int stage, RenderSettings& settings) {
    const auto add = [&app](const std::string& name, auto& value, const std::string& help,
                            const std::string& type, auto check) {
        return app.add_option(name, value, help)->check(check.description(""))->type_name(type);
    };
    if (stage >= light_stage)
        app.add_option("--term", settings.term, "show one of Phong's terms; their sum if not given")
            ->transform(CLI::CheckedTransformer(
                            std::map<std::string, PhongTerm>{{"ambient", PhongTerm::ambient},
                                                             {"diffuse", PhongTerm::diffuse},
                                                             {"specular", PhongTerm::specular}})
                            .description(""))
            ->type_name("ambient|diffuse|specular");
    if (stage >= soft_shadow_stage) {
        add("--shadow-samples", settings.shadow_samples,
            "largest number of rays to a light with a size; 16 if not given; with --samples N, "
            "divided by √N",
            "N", CLI::Range(1, most_shadow_samples));
        add_number(
            app, "--shadow-error", least_error, brightest,
            "trace shadow rays until the estimated error of a light's part is below this, of "
            "255",
            "E", [&settings](double steps) { settings.shadow_error = steps; });
        add("--shadow-agree", settings.shadow_agree,
            "or until this many agree: all reach the light, or none; with --shadow-error", "N",
            CLI::Range(1, most_shadow_samples))
            ->needs("--shadow-error");
    }
    if (stage >= mirror_stage)
        add("--depth", settings.depth, "largest number of successive reflections; 8 if not given",
            "N", CLI::Range(0, most_depth));
}

/// The path of a file in the project's folder, relative to the working directory.
std::string in_project(const Program& program, const std::string& folder, const std::string& name) {
    const auto file = std::filesystem::path(program.root) / folder / name;
    std::error_code
        no_such_folder;  // the working directory no longer exists: then the path stays as it is
    return file.lexically_proximate(std::filesystem::current_path(no_such_folder)).string();
}

std::string default_scene(const Program& program) {
    return in_project(program, "scenes", std::string(stage_name(program.stage)) + ".rt");
}

std::string default_output(const Program& program, const std::string& scene) {
    return in_project(program, "renders", std::filesystem::path(scene).stem().string() + ".png");
}

}  // namespace

std::string shade_word(int stage, Shading shading) {
    switch (shading) {
        case Shading::color:
            return stage >= light_stage ? "phong" : "torch";
        case Shading::normal:
            return "normal";
        case Shading::depth:
            return "depth";
        case Shading::id:
            return "id";
        case Shading::t:
            return "t";
        case Shading::bounces:
            return "bounces";
        case Shading::samples:
            return "samples";
        default:
            return "cost";
    }
}

std::optional<Options> parse_options(const Program& program, int argc, const char* const* argv) {
    const std::string name(stage_name(program.stage));
    Options options;
    const bool own_loop = program.stage == 1;  // common/render/stage.hpp
    options.threads = own_loop ? 1 : std::max(1, int(std::thread::hardware_concurrency()));
    bool horizontal = false;

    CLI::App app{name + ": renders a .rt scene. docs/" + name + ".md is its page.", name};
    app.option_defaults()->take_last();
    app.add_option("scene", options.scene, "the scene; scenes/" + name + ".rt if not given")
        ->type_name("FILE");
    app.add_option("-o,--output", options.output, "the picture; renders/<scene>.png if not given")
        ->type_name("PNG");
    app.add_option_function<std::string>(
           "--size", [&](const std::string& text) { options.size = parse_size(text); },
           "the picture's size in pixels, in place of the scene's")
        ->type_name("WIDTHxHEIGHT");
    add_precision(app, program, options.precision);
    add_pixel_options(app, options.settings);
    app.add_option("--threads", options.threads,
                   own_loop ? "one, the loop in main.cpp, if not given"
                            : "as many as there are cores if not given")
        ->check(CLI::Range(1, max_threads).description(""))
        ->type_name("N");
    app.add_option_function<std::string>(
           "--pixel",
           [&](const std::string& text) { options.pixel = parse_pixel("--pixel", text); },
           "print the log of one pixel's ray, and make no picture")
        ->type_name("ROW,COLUMN");
    if (program.stage >= shapes_stage)
        app.add_option_function<std::string>(
               "--rays",
               [&](const std::string& text) { options.rays = parse_pixel("--rays", text); },
               "print the rays of one pixel and the outlines of the shapes as JSON, for ./course "
               "view, and make no picture")
            ->type_name("ROW,COLUMN")
            ->excludes("--pixel");
    add_shades(app, program.stage, options);
    add_light_options(app, program.stage, options.settings);
    app.add_option(
           "--hierarchy-from", options.hierarchy_from,
           "build a hierarchy from this many shapes of a kind on; 32 if not given, 8 for meshes")
        ->check(CLI::Range(2, most_shapes).description(""))
        ->type_name("N");
    add_goals(app, options);
    add_choice(app, "--fov", horizontal, {"vertical", "horizontal"},
               "side of the picture that a scene's field of view spans");
    add_choice(app, "--cyl", options.reading.cylinder_from_base, {"center", "base"},
               "meaning of a cylinder's position");
    add_choice(app, "--hand", options.reading.axes.left_handed, {"right", "left"},
               "handedness of a scene's axes; left: left and right are exchanged");
    add_choice(app, "--up", options.reading.axes.z_up, {"y", "z"},
               "axis of the scene that points up");
    app.add_option("--camera", options.camera, "number of the scene's camera; 1 if not given")
        ->check(CLI::Range(1, max_cameras).description(""))
        ->type_name("N");
    app.add_flag("--strict", options.reading.strict,
                 "reject everything outside the format of scenes");
    app.add_flag("--requirements", options.requirements,
                 "print what the scene requires and what is omitted, and make no picture");
    app.add_flag("--preview", options.preview, "show the picture in the terminal too");
    app.add_flag("--quiet", options.quiet, "print errors only");
    if (program.stage >= camera_stage) {
        CLI::Option* const turn =
            app.add_option("--turn", options.turn,
                           "make an animated PNG of N pictures: the camera goes around the middle "
                           "of all shapes")
                ->check(CLI::Range(2, most_frames).description(""))
                ->type_name("N");
        for (const char* other :
             {"--pixel", "--requirements", "--preview", "--tolerance", "--time"})
            turn->excludes(other);
        if (program.stage >= shapes_stage) turn->excludes("--rays");
    }
    // Their output contains nothing else.
    for (const char* one : {"--pixel", "--rays"})
        if (CLI::Option* const told = app.get_option_no_throw(one))
            for (const char* other : {"--requirements", "--preview", "--tolerance", "--time"})
                told->excludes(other);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw InputError({}, std::string(error.what()) + " (--help lists the options)");
    }
    if (horizontal) options.reading.fov_axis = FovAxis::horizontal;
    check_precision(program, options.precision);
    const auto is_given = [&app](const std::string& option) {
        const CLI::Option* const known = app.get_option_no_throw(option);
        return known != nullptr && !known->empty();
    };
    if (is_given("--shadow-error") && !is_given("--shadow-samples"))
        options.settings.shadow_samples = most_shadow_samples;
    if (is_given("--pixel-error") && (options.tolerance || options.time))
        throw InputError({},
                         "--pixel-error must be given without --tolerance and --time, which "
                         "choose it");
    if (is_given("--pixel-error") && !is_given("--samples")) options.settings.pixel_samples = 1024;
    check_shade(program.stage, options, is_given);
    options.precision_given = is_given("--precision");
    options.given = {.pixel_samples = is_given("--samples"),
                     .shadow_samples = is_given("--shadow-samples") || is_given("--shadow-error"),
                     .depth = is_given("--depth")};
    for (const char* file : {"scene", "--output"})
        if (is_given(file) && app.get_option(file)->as<std::string>().empty())
            throw InputError({}, std::string(file) + " must be the name of a file, not \"\"");
    if (options.scene.empty()) options.scene = default_scene(program);
    if (options.output.empty()) options.output = default_output(program, options.scene);
    return options;
}

}  // namespace rt
