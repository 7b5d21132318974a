// The changes that a graded run makes to the fixed inputs of a suite, which anyone can read: each
// query is sent after a seeded transform, scale and so on, for which the contract determines the
// change of the answer. Random inputs stay unchanged.
//
// RAYSTEPS_AS_WRITTEN  if it is set, nothing is changed: for messages that a student can repeat
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/transform.hpp"
#include "common/image/image.hpp"
#include "common/math/real.hpp"
#include "common/render/render_settings.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

#include <array>
#include <string>

namespace rt::contract {

struct Change {
    /// Any similarity; in a case with the tag [exact], the one below.
    Transform any;
    /// Permuted and reflected axes, and a power of two as the scale: nothing is rounded, and a ray
    /// along an axis stays one. For edges, tangents, and starts on a surface.
    Transform exact;
    /// The axes of `exact`, the scale and the translation of `any`: axis-aligned boxes stay
    /// aligned.
    Transform boxes;
    /// A rotation around y, which keeps the up direction: by quarter turns in a case with the tag
    /// [exact].
    Transform upright;
    Real length = 1;                       ///< of directions: every t is divided by it
    Color dimmed = Color(1);               ///< factors of red, green and blue
    Real light = 1;                        ///< of brightness: every color is multiplied by it
    std::array<int, 3> channels{0, 1, 2};  ///< red, green and blue exchanged
    int finer = 1;  ///< odd: each pixel is divided into this many per axis, and the middle one is
                    ///< queried
    Real zoom = 1;  ///< of the tangent of half the field of view
    Pixel margin;   ///< of a picture: pixels that are added at each side
};

/// The change of the running case; null if queries are sent unchanged.
[[nodiscard]] const Change* change();

/// Draws the change of a case, if this run is graded.
void draw_change(const std::string& name, bool exact);

/// The same as `rotated` in transform.hpp, but a zero keeps its sign.
[[nodiscard]] Vec3 turned_direction(Vec3 v, const Transform& transform);
[[nodiscard]] Vec3 turned_back(Vec3 v, const Transform& transform);
[[nodiscard]] Vec3 moved_back(Vec3 point, const Transform& transform);

/// The ray's points keep their t, up to the length.
[[nodiscard]] Ray transformed(const Ray& ray, const Transform& transform, Real length = 1);
[[nodiscard]] Ray moved_back(const Ray& ray, const Transform& transform, Real length = 1);
[[nodiscard]] Interval divided(Interval interval, Real length);
[[nodiscard]] BoundingBox transformed(const BoundingBox& box, const Transform& transform);
[[nodiscard]] Mesh transformed(Mesh mesh, const Transform& transform);
/// The placement, and the motion after it.
[[nodiscard]] Transform transformed(const Transform& placement, const Transform& transform);
[[nodiscard]] MeshInstance transformed(const MeshInstance& mesh, const Transform& transform);
/// p ↦ M p, in homogeneous coordinates.
[[nodiscard]] Mat4 matrix_of(const Transform& transform);

[[nodiscard]] Color exchanged(Color color, const Change& change);
[[nodiscard]] Color exchanged_back(Color color, const Change& change);
[[nodiscard]] ShadingPoint changed(ShadingPoint surface, const Change& change,
                                   const Transform& transform);
[[nodiscard]] Light changed(Light light, const Change& change, const Transform& transform);
[[nodiscard]] Ambient changed(Ambient light, const Change& change, const Transform& transform);

// The change of a scene of one pixel, and of the color that `trace` returns for it; and that of a
// picture without shapes.

/// The whole scene, with its camera, transformed: with a sky around the vertical alone, and with
/// --shade normal to other axes. The channels of its light, of its sky and, without any light, of
/// its shapes' colors are exchanged, and each dimmed by a factor of its own.
[[nodiscard]] Scene changed(const Scene& scene, const RenderSettings& settings,
                            const Change& change);

/// The color for the scene, from that for the changed scene.
[[nodiscard]] Color changed_back(Color color, const Scene& scene, const RenderSettings& settings,
                                 const Change& change);

/// The scene of a larger picture, whose middle is that of the scene. With shapes the scene itself:
/// there, random numbers of a pixel depend on its place in the picture.
[[nodiscard]] Scene enlarged(const Scene& scene, const Change& change);

/// The scene's picture, from that of the enlarged scene.
[[nodiscard]] Image middle_of(const Image& picture, Resolution size);

}  // namespace rt::contract
