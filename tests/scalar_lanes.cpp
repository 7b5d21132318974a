#define RT_LANES scalar_lanes

#include "tests/scalar_lanes.hpp"

#include "common/box_ranges.cpp"
#include "common/hierarchy.cpp"
#include "common/packed_mesh.cpp"

namespace rt {

std::vector<std::optional<MeshHit>> hits_without_vectors(const Mesh& mesh,
                                                         const std::vector<Ray>& rays) {
    const PackedMesh packed(mesh);
    std::vector<std::optional<MeshHit>> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(packed.nearest(ray, {}));
    return hits;
}

}  // namespace rt
