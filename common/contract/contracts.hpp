// The functions of every stage's contract.
#pragma once

#include "common/contract/functions.hpp"
#include "common/stages/stages.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step13_meshes/meshes.hpp"

namespace rt::contract {

// Selects an overload.
template <class Shape>
using Intersect = std::optional<Real> (*)(const Ray&, const Shape&, Interval);
template <class Shape>
using Normal = Vec3 (*)(const Shape&, Vec3);
using IntersectMesh = std::optional<MeshHit> (*)(const Ray&, const Mesh&, Interval);

template <int Stage>
struct Contract;

template <>
struct Contract<1> {
    using Functions =
        std::tuple<Function<"pixel_on_screen", pixel_on_screen>, Function<"camera_ray", camera_ray>,
                   Function<"unprojected_ray", unprojected_ray>>;
};

template <>
struct Contract<2> {
    using Functions =
        std::tuple<Function<"orthonormal_basis", orthonormal_basis>,
                   Function<"camera_basis", camera_basis>, Function<"to_world", to_world>,
                   Function<"view_matrix", view_matrix>>;
};

template <>
struct Contract<3> {
    using Functions =
        std::tuple<Function<"intersect", Intersect<Sphere>(intersect)>,
                   Function<"normal", Normal<Sphere>(normal)>,
                   Function<"color_from_normal", color_from_normal>, Function<"torch", torch>>;
};

template <>
struct Contract<4> {
    using Functions = std::tuple<Function<"intersect", Intersect<Plane>(intersect)>,
                                 Function<"normal", Normal<Plane>(normal)>>;
};

template <>
struct Contract<5> {
    using Functions = std::tuple<Function<"intersect", Intersect<Triangle>(intersect)>,
                                 Function<"barycentric", barycentric>,
                                 Function<"normal", Normal<Triangle>(normal)>>;
};

template <>
struct Contract<6> {
    using Functions =
        std::tuple<Function<"intersect", Intersect<Square>(intersect)>,
                   Function<"square_uv", square_uv>, Function<"normal", Normal<Square>(normal)>>;
};

template <>
struct Contract<7> {
    using Functions = std::tuple<Function<"intersect", Intersect<Cylinder>(intersect)>,
                                 Function<"normal", Normal<Cylinder>(normal)>>;
};

template <>
struct Contract<8> {
    using Functions = std::tuple<Function<"intersect", Intersect<Cone>(intersect)>,
                                 Function<"normal", Normal<Cone>(normal)>>;
};

template <>
struct Contract<9> {
    using Functions =
        std::tuple<Function<"reflected", reflected>, Function<"ambient_term", ambient_term>,
                   Function<"diffuse_term", diffuse_term>,
                   Function<"specular_term", specular_term>>;
};

template <>
struct Contract<10> {
    using Functions = std::tuple<Function<"shadow_ray", shadow_ray>>;
};

template <>
struct Contract<11> {
    using Functions =
        std::tuple<Function<"sample_light", sample_light>, Function<"visibility", visibility>,
                   Function<"visibility_error", visibility_error>>;
};

template <>
struct Contract<12> {
    using Functions = std::tuple<Function<"mirrored", mirrored>, Function<"mixed", mixed>,
                                 Function<"worth_reflecting", worth_reflecting>>;
};

template <>
struct Contract<13> {
    using Functions = std::tuple<Function<"overlap", overlap>,
                                 Function<"intersect", Intersect<OrientedBox>(intersect)>,
                                 Function<"normal", Normal<OrientedBox>(normal)>,
                                 Function<"to_object_space", to_object_space>,
                                 Function<"intersect", IntersectMesh(intersect)>,
                                 Function<"interpolated_normal", interpolated_normal>>;
};

inline constexpr int stage_count = int(stage_names.size());

/// Calls visit(stage, function) for all functions, where function is a Function{} that serves as
/// its type only: Function<…>.
template <int Stage = 1, class Visit>
void for_each_function(Visit visit) {
    []<class... Each>(std::type_identity<std::tuple<Each...>>, Visit& visit_one) {
        (visit_one(Stage, Each{}), ...);
    }(std::type_identity<typename Contract<Stage>::Functions>(), visit);
    if constexpr (Stage < stage_count) for_each_function<Stage + 1>(visit);
}

/// The number of a function in a query: its stage, and its place in the contract.
struct Number {
    std::uint8_t stage;
    std::uint8_t place;
};
template <>
inline constexpr auto record<Number> = record_of("Number", field("stage", &Number::stage),
                                                 field("place", &Number::place));

// The numbers of queries that are not of one function: whole pictures, many points of a light, and
// the color that `trace` returns.
inline constexpr std::uint8_t picture_place = 255;
inline constexpr std::uint8_t light_points_place = 254;
inline constexpr std::uint8_t trace_place = 253;

}  // namespace rt::contract
