// The form of a mesh, found on the half-edges of OpenMesh.
#pragma once

#include "common/geometry/mesh_edges.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// The parts, holes and edges that the triangles of a mesh form.
struct MeshForm {
    std::size_t parts = 0;          ///< not connected by a vertex
    std::size_t holes = 0;          ///< closed ways along edges of one triangle
    std::size_t longest_hole = 0;   ///< edges
    std::size_t crowded_edges = 0;  ///< of three triangles or more, which half-edges cannot have
    std::size_t turned = 0;         ///< triangles that are turned over, compared to their neighbors
    std::size_t one_sided = 0;  ///< triangles of parts with one side, which half-edges cannot have
};

/// Adds the closed ways along half-edges without a face to the form. `groups` are those of the
/// corners (mesh_edges.hpp) of triangles of which none is turned over; what has one side is cut
/// open.
extern "C" void raysteps_count_holes(const std::vector<std::uint32_t>& groups, MeshForm& form);

/// Returns the form of the triangles; vertices in the same place must be one.
[[nodiscard]] MeshForm form_of(const Triangles& triangles, std::size_t vertices);

}  // namespace rt
