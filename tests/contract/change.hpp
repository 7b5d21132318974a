// What a graded run does to the questions that stand in a suite, and are known to whoever reads it:
// each is asked after a seeded motion, scale and the like, under which the contract says what
// becomes of the answer. Questions that are drawn at random are asked as they are.
//
// RAYSTEPS_AS_WRITTEN  if it is set, nothing is changed: for words that a student can repeat
#pragma once

#include "common/box.hpp"
#include "common/mesh.hpp"
#include "common/motion.hpp"
#include "common/scene.hpp"
#include "common/surface.hpp"

#include <array>
#include <string>

namespace rt::contract {

struct Change {
    /// Any similarity; in a case with the tag [exact], the one below.
    Motion any;
    /// Axes exchanged and turned round, a scale that is a power of two: nothing is rounded, and a
    /// ray along an axis stays one. For edges, tangents, and starts on a surface.
    Motion exact;
    /// The axes of `exact`, the scale and the way of `any`: boxes along the axes stay boxes.
    Motion boxes;
    /// A turn round y, as which way is up stays: by quarters in a case with the tag [exact].
    Motion upright;
    Real length = 1;                       ///< of directions, by which every t is divided
    Real light = 1;                        ///< of brightness, by which every colour is multiplied
    std::array<int, 3> channels{0, 1, 2};  ///< red, green and blue exchanged
    int finer = 1;  ///< odd: pixels cut into so many, the middle one asked for
    Real zoom = 1;  ///< of the tangent of half the field of view
};

/// The running case's; none where questions are asked as they are.
[[nodiscard]] const Change* change();

/// Draws the change of a case, if this run is graded.
void draw_change(const std::string& name, bool exact);

/// As turned of motion.hpp, but a zero keeps its sign.
[[nodiscard]] Vec3 turned_direction(Vec3 v, const Motion& motion);
[[nodiscard]] Vec3 turned_back(Vec3 v, const Motion& motion);
[[nodiscard]] Vec3 moved_back(Vec3 point, const Motion& motion);

/// The ray's points keep their t, but for the length.
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
