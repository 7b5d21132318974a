// The changes that a graded run makes to the fixed inputs of a suite, which anyone can read: each
// query is sent after a seeded transform, scale and so on, for which the contract determines the
// change of the answer. Random inputs stay unchanged.
//
// RAYSTEPS_AS_WRITTEN  if it is set, nothing is changed: for messages that a student can repeat
#pragma once

#include "common/geometry/bounding_box.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/transform.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

#include <array>
#include <string>

namespace rt::contract {

struct Change {
    /// Any similarity; in a case with the tag [exact], the one below.
    Motion any;
    /// Permuted and reflected axes, and a power of two as the scale: nothing is rounded, and a ray
    /// along an axis stays one. For edges, tangents, and starts on a surface.
    Motion exact;
    /// The axes of `exact`, the scale and the translation of `any`: axis-aligned boxes stay
    /// aligned.
    Motion boxes;
    /// A rotation around y, which keeps the up direction: by quarter turns in a case with the tag
    /// [exact].
    Motion upright;
    Real length = 1;                       ///< of directions: every t is divided by it
    Real light = 1;                        ///< of brightness: every color is multiplied by it
    std::array<int, 3> channels{0, 1, 2};  ///< red, green and blue exchanged
    int finer = 1;  ///< odd: each pixel is divided into this many per axis, and the middle one is
                    ///< queried
    Real zoom = 1;  ///< of the tangent of half the field of view
};

/// The change of the running case; null if queries are sent unchanged.
[[nodiscard]] const Change* change();

/// Draws the change of a case, if this run is graded.
void draw_change(const std::string& name, bool exact);

/// The same as `turned` in transform.hpp, but a zero keeps its sign.
[[nodiscard]] Vec3 turned_direction(Vec3 v, const Motion& motion);
[[nodiscard]] Vec3 turned_back(Vec3 v, const Motion& motion);
[[nodiscard]] Vec3 moved_back(Vec3 point, const Motion& motion);

/// The ray's points keep their t, up to the length.
[[nodiscard]] Ray moved(const Ray& ray, const Motion& motion, Real length = 1);
[[nodiscard]] Ray moved_back(const Ray& ray, const Motion& motion, Real length = 1);
[[nodiscard]] Interval divided(Interval interval, Real length);
[[nodiscard]] Basis turned(const Basis& basis, const Motion& motion);
[[nodiscard]] Box moved(const Box& box, const Motion& motion);
[[nodiscard]] Mesh moved(Mesh mesh, const Motion& motion);
/// The placement, and the motion after it.
[[nodiscard]] Motion moved(const Motion& placement, const Motion& motion);
/// p ↦ M p, in homogeneous coordinates.
[[nodiscard]] Mat4 matrix_of(const Motion& motion);

[[nodiscard]] Color exchanged(Color color, const Change& change);
[[nodiscard]] Color exchanged_back(Color color, const Change& change);
[[nodiscard]] Surface changed(Surface surface, const Change& change, const Motion& motion);
[[nodiscard]] Light changed(Light light, const Change& change, const Motion& motion);

}  // namespace rt::contract
