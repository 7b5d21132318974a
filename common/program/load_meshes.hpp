// Loading of the meshes that a scene names.
#pragma once

#include "common/scene/scene.hpp"

#include <string>

namespace rt {

/// Loads the scene's named meshes, each file once, and adds an instance for each. Throws InputError
/// for a file that is wrong; the error and each warning include the line of the scene that names
/// the file. Only the program of a stage with meshes has this function: in the others
/// no_meshes.cpp takes its place, so that they do not need OpenMesh.
void load_meshes(Scene& scene, const Warn& warn = nullptr);

/// "the mesh of scene.rt:4:1", for messages about the file that is named there.
[[nodiscard]] inline std::string named_by(const FileLocation& place) {
    std::string text = to_string(place);
    text.resize(text.rfind(':'));
    return "the mesh of " + text;
}

/// Returns the lines about the meshes' files that `--requirements` prints: what their triangles
/// form (common/mesh_file/half_edges.hpp), and their box. Throws InputError, and warns, as
/// load_meshes does.
[[nodiscard]] std::string mesh_forms(const Scene& scene, const Warn& warn = nullptr);

}  // namespace rt
