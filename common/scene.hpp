// What a .rt file describes.
#pragma once

#include "common/axes.hpp"
#include "common/input_error.hpp"
#include "common/items.hpp"
#include "common/pixel.hpp"
#include "common/placed_mesh.hpp"
#include "common/shapes.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// Which side of the picture the field of view spans. The format does not say; MRT §1 has the
/// vertical, and miniRT's subject the horizontal.
enum class FovAxis { vertical, horizontal };

}  // namespace rt

namespace rt::inline RT_PRECISION {

struct Camera {
    Vec3 position;
    Vec3 direction{0, 0, -1};  ///< unit length
    Real fov = pi / 3;         ///< radians, 0 to π
    FovAxis fov_axis = FovAxis::vertical;
};

/// Light that is everywhere.
struct Ambient {
    Real ratio = 0;  ///< 0 to 1
    Color color{1};
};

struct Light {
    Vec3 position;
    Real brightness = 1;  ///< 0 to 1
    Color color{1};
    Real radius = 0;  ///< of the sphere that shines; 0 for a point
};

/// A mesh that a scene names. It is loaded once the stage is known to have meshes.
struct NamedMesh {
    Place place;         ///< of its element
    std::string file;    ///< from the scene's folder
    bool smooth = true;  ///< normals interpolated; else faces flat
    Motion placement;
    Material material;
};

/// One list a kind of shape: an empty kind costs nothing, and no shape needs a base class.
struct Scene {
    Resolution resolution;
    std::vector<Camera> cameras;  ///< at least one; pictures use the first
    std::optional<Ambient> ambient;
    std::vector<Light> lights;

    Items<Sphere> spheres;
    Items<Plane> planes;
    Items<Triangle> triangles;
    Items<Square> squares;
    Items<Cylinder> cylinders;
    Items<Cone> cones;
    Items<OrientedBox> boxes;
    std::vector<NamedMesh> named_meshes;
    Items<PlacedMesh> meshes;  ///< the named ones, once they are loaded

    Axes axes;  ///< the file's; all of the above is in ours
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The angle between the top and the bottom edge of the picture, in radians, whichever axis the
/// camera's field of view is given along.
[[nodiscard]] Real vertical_fov(const Camera& camera, Resolution resolution);

/// Calls visit(items) for each kind of shape, meshes apart.
template <class SomeScene, class Visit>
void for_each_kind(SomeScene& scene, Visit visit) {
    visit(scene.spheres);
    visit(scene.planes);
    visit(scene.triangles);
    visit(scene.squares);
    visit(scene.cylinders);
    visit(scene.cones);
    visit(scene.boxes);
}

/// The mesh's file, as the scene's folder sees it, wherever the program runs.
[[nodiscard]] std::string path_of(const NamedMesh& mesh);

/// Arranges each kind of shape, once the scene is whole. Pictures are the same without, but later.
void arrange(Scene& scene, const Arrangement& how = {});

}  // namespace rt
