// What a .rt file describes.
#pragma once

#include "common/pixel.hpp"
#include "common/shapes.hpp"

#include <optional>
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
};

struct Material {
    Color color{1};
};

/// A shape and what it is made of.
template <class Shape>
struct Item {
    Shape shape;
    Material material;
};

/// One list a kind of shape: an empty kind costs nothing, and no shape needs a base class.
struct Scene {
    Resolution resolution;
    std::vector<Camera> cameras;  ///< at least one; pictures use the first
    std::optional<Ambient> ambient;
    std::vector<Light> lights;

    std::vector<Item<Sphere>> spheres;
    std::vector<Item<Plane>> planes;
    std::vector<Item<Triangle>> triangles;
    std::vector<Item<Square>> squares;
    std::vector<Item<Cylinder>> cylinders;
    std::vector<Item<Cone>> cones;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The angle between the top and the bottom edge of the picture, in radians, whichever axis the
/// camera's field of view is given along.
[[nodiscard]] Real vertical_fov(const Camera& camera, Resolution resolution);

}  // namespace rt
