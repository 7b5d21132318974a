// Faces of any number of corners that share their vertices, and the few ways to build them.
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace rt {

struct Polygons {
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;      ///< one a vertex, or none at all
    std::vector<std::vector<int>> faces;  ///< anticlockwise from outside
};

/// An ellipse: the center, and the vectors to its end and to its side.
struct Ellipse {
    glm::dvec3 center;
    glm::dvec3 across;
    glm::dvec3 along;
};

void append(Polygons& polygons, const Polygons& more);

/// The other one of a pair: x becomes −x.
[[nodiscard]] Polygons mirrored(Polygons polygons);

/// A closed box.
[[nodiscard]] Polygons box(glm::dvec3 center, glm::dvec3 half_size);

/// A closed skin over ellipses, `corners` on each, the first and the last filled. They follow each
/// other in the direction of across × along.
[[nodiscard]] Polygons loft(const std::vector<Ellipse>& ellipses, int corners);

/// A closed ring along the ellipse, of four sides, each `thickness` wide.
[[nodiscard]] Polygons ring(const Ellipse& ellipse, double thickness, int corners);

/// Every face of more than three corners, cut into triangles.
[[nodiscard]] Polygons cut_up(Polygons polygons);

// Rounder meshes, by OpenMesh's subdivision: refine.cpp

/// Each time, every face of n corners becomes n quadrilaterals (Catmull, Clark 1978).
[[nodiscard]] Polygons catmull_clark(const Polygons& polygons, int times);

/// Each time, every triangle becomes four (Loop 1987). All faces must be triangles.
[[nodiscard]] Polygons loop(const Polygons& polygons, int times);

/// With a normal a vertex, the mean of its faces' weighted by their angles there.
[[nodiscard]] Polygons with_normals(Polygons polygons);

}  // namespace rt
