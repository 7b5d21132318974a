#include "common/course/build/project.hpp"

#include "common/system/translation.hpp"

#include <algorithm>

namespace rt {

const fs::path project_folder = RAYSTEPS_ROOT;
const fs::path build_folder = RAYSTEPS_BUILD;
const bool has_meshes = RAYSTEPS_MESHES;
const bool has_oracle = RAYSTEPS_ORACLE;

std::string project_language() {
    const std::string language = language_of_environment();
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const bool is_name = !language.empty() && std::ranges::all_of(language, is_letter);
    return is_name && fs::exists(project_folder / "lang" / language) ? language : "";
}

void read_project_translations(const std::string& name) {
    const std::string language = project_language();
    if (!language.empty()) read_translations(project_folder / "lang" / language / (name + ".po"));
}

}  // namespace rt
