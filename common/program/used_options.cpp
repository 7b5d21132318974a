#include "common/program/used_options.hpp"

#include "common/program/shade_options.hpp"
#include "common/stages/stages.hpp"
#include "common/system/version.hpp"

#include <charconv>
#include <filesystem>

namespace rt {

namespace {

/// The shortest text that identifies the number.
std::string shortest(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

const char* name(Precision precision) {
    if (precision == Precision::exact) return "exact";
    return precision == Precision::f32 ? "float" : "double";
}

std::string used_options(const Program& program, const Options& options) {
    const RenderSettings& settings = options.settings;
    std::string used = "--shade " + shade_word(program.stage, settings.shading);
    if (const auto& range = options.shade_range)
        used += " --shade-range " + shortest((*range)[0]) + "," + shortest((*range)[1]);
    if (settings.term == PhongTerm::ambient) used += " --term ambient";
    if (settings.term == PhongTerm::diffuse) used += " --term diffuse";
    if (settings.term == PhongTerm::specular) used += " --term specular";
    if (settings.pixel_samples > 1) used += " --samples " + std::to_string(settings.pixel_samples);
    if (settings.pixel_error > 0) used += " --pixel-error " + shortest(settings.pixel_error);
    if (settings.gamma == Gamma::linear) used += " --gamma linear";
    if (settings.gamma == Gamma::srgb) used += " --gamma srgb";
    if (program.stage >= soft_shadow_stage)
        used += " --shadow-samples " + std::to_string(settings.shadow_samples);
    if (settings.shadow_error > 0) used += " --shadow-error " + shortest(settings.shadow_error);
    if (settings.shadow_agree > 0)
        used += " --shadow-agree " + std::to_string(settings.shadow_agree);
    if (program.stage >= mirror_stage) used += " --depth " + std::to_string(settings.depth);
    if (options.hierarchy_from)
        used += " --hierarchy-from " + std::to_string(*options.hierarchy_from);
    if (options.reading.fov_axis == FovAxis::horizontal) used += " --fov horizontal";
    if (options.reading.cylinder_from_base) used += " --cyl base";
    if (options.reading.axes.left_handed) used += " --hand left";
    if (options.reading.axes.z_up) used += " --up z";
    if (options.camera != 1) used += " --camera " + std::to_string(options.camera);
    if (options.turn) used += " --turn " + std::to_string(*options.turn);
    if (options.reading.strict) used += " --strict";
    if (options.time) used += " --time " + shortest(*options.time);
    return used;
}

std::string equivalent_options(const Program& program, const Options& options) {
    return std::string("--precision ") + name(options.precision) + " " +
           used_options(program, options);
}

std::string size_text(Resolution size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

std::vector<PngText> picture_texts(const Program& program, const Options& options,
                                   Resolution size) {
    const bool is_float = options.precision == Precision::f32;
    const std::string used =
        is_float ? equivalent_options(program, options) : used_options(program, options);
    return {{"Title", std::filesystem::path(options.scene).filename().string()},
            {"Software", "Raysteps " + version_number() + " " + name_of(program.stage)},
            {"Size", size_text(size)},
            {"Precision", name(options.precision)},
            {"Options", used}};
}

}  // namespace rt
