// An instance of a mesh in a scene.
#pragma once

#include "common/bvh/mesh_bvh.hpp"
#include "common/geometry/bounding_box.hpp"
#include "common/geometry/bounding_sphere.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/transform.hpp"

#include <memory>
#include <optional>

namespace rt {
inline namespace RT_PRECISION {

#ifdef RT_EXACT
/// Only packed meshes can order two hits exactly whose rounded t are too close to compare.
inline constexpr std::size_t mesh_bvh_pays_from = 1;
#else
/// The number of triangles from which packing is faster. Smaller meshes, such as a cube of twelve
/// triangles, are tested triangle by triangle.
inline constexpr std::size_t mesh_bvh_pays_from = 16;
#endif

/// A mesh as its file defines it and, if it has many triangles, a packed copy of them.
struct MeshGeometry {
    Mesh mesh;
    BoundingBox bounds;
    std::optional<MeshBvh> packed;
};

/// An instance of a mesh: each point p of the model is at transformed(p, placement). Instances may
/// share one model, which does not change: rays are transformed to object space instead (M1,
/// "changement de repère").
struct MeshInstance {
    std::shared_ptr<const MeshGeometry> model;
    Transform placement;

    bool operator==(const MeshInstance&) const = default;
};

/// Intersecting a mesh is slow, and its bounding sphere is a loose fit.
template <>
inline constexpr std::size_t bvh_pays_from<MeshInstance> = 8;

}  // namespace RT_PRECISION

/// The mesh with its bounds, packed if that is faster.
[[nodiscard]] std::shared_ptr<const MeshGeometry> mesh_geometry(Mesh mesh);

/// The bounding box of the model's transformed bounds.
[[nodiscard]] BoundingBox bounds(const MeshInstance& instance);

[[nodiscard]] BoundingSphere bounding_sphere(const MeshInstance& instance);

}  // namespace rt
