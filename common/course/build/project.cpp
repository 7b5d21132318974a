#include "common/course/build/project.hpp"

namespace rt {

const std::filesystem::path project_folder = RAYSTEPS_ROOT;
const std::filesystem::path build_folder = RAYSTEPS_BUILD;
const bool has_meshes = RAYSTEPS_MESHES;
const bool has_oracle = RAYSTEPS_ORACLE;

}  // namespace rt
