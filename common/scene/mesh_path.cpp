#include "common/scene/scene.hpp"

#include <filesystem>

namespace rt {

std::string path_of(const MeshRequest& mesh) {
    return (std::filesystem::path(mesh.place.file).parent_path() / mesh.file).string();
}

}  // namespace rt
