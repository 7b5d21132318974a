// The content of a .rt file.
#pragma once

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "common/image/pixel.hpp"
#include "common/scene/axes.hpp"
#include "common/scene/light.hpp"
#include "common/scene/mesh_instance.hpp"
#include "common/scene/primitives.hpp"
#include "common/system/input_error.hpp"

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace rt {

/// The side of the picture that the field of view spans. The format does not define it; MRT §1 uses
/// the vertical side, and miniRT's subject the horizontal one.
enum class FovAxis { vertical, horizontal };

inline namespace RT_PRECISION {

/// A camera: all lengths in units of the scene.
struct Camera {
    Vec3 position;
    Vec3 direction{0, 0, -1};  ///< unit length
    Real fov = pi / 3;         ///< radians, 0 to π
    FovAxis fov_axis = FovAxis::vertical;
};

/// The sky, what a ray sees that hits nothing: a gradient of two colors by the ray's direction.
struct Sky {
    Color bottom;  ///< straight down
    Color top;     ///< straight up
};

/// A mesh that a scene names. It is loaded later, once the stage is known to support meshes.
struct MeshRequest {
    FileLocation place;  ///< location of its element in the scene file
    std::string file;    ///< path relative to the scene's folder
    bool smooth = true;  ///< interpolate normals; otherwise faces are flat
    Transform placement;
    Material material;
};

/// A scene. Each kind of shape has its own list, so that an absent kind costs nothing and shapes
/// need no base class.
struct Scene {
    Resolution resolution;
    std::vector<Camera> cameras;  ///< at least one; a picture uses the first
    std::optional<Ambient> ambient;
    std::vector<Light> lights;
    std::optional<Sky> sky;  ///< black without one

    PrimitiveList<Sphere> spheres;
    PrimitiveList<Plane> planes;
    PrimitiveList<Triangle> triangles;
    PrimitiveList<Square> squares;
    PrimitiveList<Cylinder> cylinders;
    PrimitiveList<Cone> cones;
    PrimitiveList<OrientedBox> boxes;
    std::vector<MeshRequest> mesh_requests;
    PrimitiveList<MeshInstance> meshes;  ///< the instances, once the named meshes are loaded

    Axes axes;  ///< axes of the file; all members above use the program's axes
};

/// A kind of shape: its list, the stage that brings it, and its names.
template <KindOfShape Shape>
requires BoundedKindOfShape<Shape> || std::same_as<Shape, Plane>
struct ShapeKind {
    PrimitiveList<Shape> Scene::*primitives;
    int stage;
    const char* one;
    const char* many;
};

/// All kinds but meshes: whatever is done with each kind of shape follows this list.
inline constexpr std::tuple shape_kinds{
    ShapeKind<Sphere>{&Scene::spheres, 3, "sphere", "spheres"},
    ShapeKind<Plane>{&Scene::planes, 4, "plane", "planes"},
    ShapeKind<Triangle>{&Scene::triangles, 5, "triangle", "triangles"},
    ShapeKind<Square>{&Scene::squares, 6, "square", "squares"},
    ShapeKind<Cylinder>{&Scene::cylinders, 7, "cylinder", "cylinders"},
    ShapeKind<Cone>{&Scene::cones, 8, "cone", "cones"},
    ShapeKind<OrientedBox>{&Scene::boxes, 13, "box", "boxes"},
};

/// The number of lists of shapes in a scene, meshes included.
inline constexpr std::size_t list_count = std::tuple_size_v<decltype(shape_kinds)> + 1;

}  // namespace RT_PRECISION

/// The angle between the top and the bottom edge of the picture, in radians, for a field of view
/// given along either axis.
[[nodiscard]] Real vertical_fov(const Camera& camera, Resolution resolution);

/// Calls visit(list) for the list of each kind of shape, except meshes.
template <class SomeScene, class Visit>
void for_each_kind(SomeScene& scene, Visit visit) {
    std::apply([&](const auto&... kind) { (visit(scene.*kind.primitives), ...); }, shape_kinds);
}

/// The bounding box of all shapes except planes; empty if there are none.
[[nodiscard]] inline BoundingBox box_of_shapes(const Scene& scene) {
    BoundingBox all;
    for_each_kind(scene, [&all](const auto& primitives) { all = merged(all, primitives.box()); });
    return merged(all, scene.meshes.box());
}

/// The path of the mesh's file, resolved from the scene's folder, independent of the working
/// directory.
[[nodiscard]] std::string path_of(const MeshRequest& mesh);

/// Builds the acceleration structure of each kind of shape, once the scene is complete. Without it,
/// pictures are the same but slower.
void build_acceleration(Scene& scene, const Acceleration& how = {});

}  // namespace rt
