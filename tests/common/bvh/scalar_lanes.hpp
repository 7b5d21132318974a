// MeshBvh once more, with lanes that are taken one after the other.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/ray.hpp"

#include <optional>
#include <vector>

namespace rt {

/// The hits of MeshBvh for each ray if the compiler has no vectors.
[[nodiscard]] std::vector<std::optional<MeshHit>> hits_without_vectors(
    const Mesh& mesh, const std::vector<Ray>& rays);

}  // namespace rt
