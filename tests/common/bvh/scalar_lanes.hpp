// MeshBvh once more, with other lanes than this processor's.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/ray.hpp"

#include <optional>
#include <vector>

namespace rt {

/// The hits of MeshBvh for each ray if the compiler has no vectors.
[[nodiscard]] std::vector<std::optional<MeshHit>> hits_of_scalar_lanes(
    const Mesh& mesh, const std::vector<Ray>& rays);

/// The same with vectors of 16 bytes.
[[nodiscard]] std::vector<std::optional<MeshHit>> hits_of_vector_lanes(
    const Mesh& mesh, const std::vector<Ray>& rays);

}  // namespace rt
