#include "common/mesh_file/load_mesh.hpp"

#include "common/geometry/mesh_normals.hpp"
#include "common/mesh_file/mesh_file.hpp"
#include "common/system/huge_pages.hpp"

#include <limits>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {

namespace {

std::vector<Vec3> as_real(const std::vector<glm::vec3>& values) {
    std::vector<Vec3> result;
    reserve_huge(result, values.size());
    result.assign(values.begin(), values.end());
    return result;
}

/// Scales every normal to unit length; replaces a zero or NaN normal by a smooth normal.
void repair_normals(Mesh& mesh) {
    std::vector<Vec3> smooth;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const double length = glm::length(glm::dvec3(mesh.normals[i]));
        if (length > 0 && length < std::numeric_limits<double>::infinity()) {  // also false for NaN
            mesh.normals[i] = Vec3(glm::dvec3(mesh.normals[i]) / length);
            continue;
        }
        if (smooth.empty()) smooth = smooth_normals(mesh);
        mesh.normals[i] = smooth[i];
    }
}

}  // namespace

Mesh load_mesh(const std::string& file, const Warn& warn) {
    MeshFile content = read_mesh_file(file);
    for (const std::string& warning : content.warnings)
        if (warn) warn(to_string(FileLocation{file}) + "warning: " + warning);
    Mesh mesh = {.vertices = as_real(content.vertices),
                 .normals = as_real(content.normals),
                 .triangles = std::move(content.triangles)};
    repair_normals(mesh);
    return mesh;
}

}  // namespace RT_PRECISION
}  // namespace rt
