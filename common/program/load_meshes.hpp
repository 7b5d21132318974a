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

/// Reads a file by `read(warn)`. Its warnings and errors also have the line of the scene that names
/// the file: "the mesh of scene.rt:4".
template <class Read>
[[nodiscard]] auto read_named(const MeshRequest& named, const Warn& warn, const Read& read) {
    std::string line = to_string(named.place);
    line = "the mesh of " + line.substr(0, line.rfind(':'));
    try {
        return read([&](const std::string& warning) {
            if (warn) warn(warning + " (" + line + ")");
        });
    } catch (const InputError& error) {
        throw error.with(line);
    }
}

/// Returns the lines about the meshes' files that `--requirements` prints: what their triangles
/// form (common/mesh_file/half_edges.hpp), and their box. Throws InputError, and warns, as
/// load_meshes does.
[[nodiscard]] std::string mesh_forms(const Scene& scene, const Warn& warn = nullptr);

}  // namespace rt
