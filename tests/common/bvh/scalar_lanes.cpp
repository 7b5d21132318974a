#ifndef RT_LANES
#define RT_LANES scalar_lanes
#endif

#include "tests/common/bvh/scalar_lanes.hpp"

#ifdef RT_LANES_OF_LIBRARY
#include "common/bvh/mesh_bvh.hpp"
#else
#include "common/bvh/binned_sah.cpp"
#include "common/bvh/bvh.cpp"
#include "common/bvh/mesh_bvh.cpp"
#endif

namespace rt {

std::vector<std::optional<MeshHit>> hits_of_scalar_lanes(const Mesh& mesh,
                                                         const std::vector<Ray>& rays) {
    const MeshBvh packed(mesh);
    std::vector<std::optional<MeshHit>> hits;
    hits.reserve(rays.size());
    for (const Ray& ray : rays) hits.push_back(packed.nearest(ray, {}));
    return hits;
}

}  // namespace rt
