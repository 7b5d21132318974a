// A mesh somewhere in a scene.
#pragma once

#include "common/balls.hpp"
#include "common/box.hpp"
#include "common/mesh.hpp"
#include "common/motion.hpp"
#include "common/packed_mesh.hpp"

#include <memory>
#include <optional>

namespace rt::inline RT_PRECISION {

#ifdef RT_EXACT
/// Packed ones alone know which of two is nearer where their t do not tell.
inline constexpr std::size_t packing_pays_from = 1;
#else
/// As many triangles as packing pays from; fewer, a cube's twelve, are asked one by one.
inline constexpr std::size_t packing_pays_from = 16;
#endif

/// A mesh as its file has it, and the same triangles packed for rays if there are many.
struct Model {
    Mesh mesh;
    Box bounds;
    std::optional<PackedMesh> packed;
};

/// The model's triangles, each point p at moved(p, placement). The mesh itself stays as it is, and
/// several may share it: rays are carried into its frame instead (M1, "changement de repère").
struct PlacedMesh {
    std::shared_ptr<const Model> model;
    Motion placement;

    bool operator==(const PlacedMesh&) const = default;
};

/// A mesh is slow to ask, and its balls are wide.
template <>
inline constexpr std::size_t hierarchy_pays_from<PlacedMesh> = 8;

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// Around the model's bounds, turned and moved.
[[nodiscard]] Box bounds(const PlacedMesh& placed);

[[nodiscard]] Ball ball_around(const PlacedMesh& placed);

}  // namespace rt
