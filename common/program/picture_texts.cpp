#include "common/program/picture_texts.hpp"

#include "common/program/used_options.hpp"
#include "common/stages/stages.hpp"
#include "common/system/version.hpp"

#include <filesystem>

namespace rt {

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
