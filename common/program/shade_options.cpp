#include "common/program/shade_options.hpp"

#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/parse_floating.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace rt {

namespace {

constexpr double least_shown = 1e-30;
constexpr double most_shown = 1e30;

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
    const std::string_view both(text);
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto low = whole_floating<double>(both.substr(0, comma));
    const auto high = whole_floating<double>(both.substr(std::min(comma + 1, text.size())));
    if (!low || !high || !(least_shown <= *low && *low < *high && *high <= most_shown))
        throw InputError({},
                         "--shade-range must be two numbers LOW,HIGH with 1e-30 <= LOW < HIGH <= "
                         "1e30, not " +
                             rt::quoted(text));
    return {*low, *high};
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
        case Shading::cost:
            return "cost";
    }
    return "";
}

void add_shade_options(CLI::App& app, int stage, Options& options) {
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

void check_shade_options(int stage, const Options& options, const IsGiven& is_given) {
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

}  // namespace rt
