// The distance of a point from a surface, and from the part of it that is the shape.
#pragma once

#include "tests/oracle/shapes.hpp"

namespace rt::oracle {

/// The point's distance from the whole sphere, plane, tube or double cone that contains the shape.
/// For a double cone, the distance from the closest of its lines; for a box, from its faces.
[[nodiscard]] Number off_surface(const ExactVector& point, const Sphere& sphere);
[[nodiscard]] Number off_surface(const ExactVector& point, const Plane& plane);
[[nodiscard]] Number off_surface(const ExactVector& point, const Triangle& triangle);
[[nodiscard]] Number off_surface(const ExactVector& point, const Square& square);
[[nodiscard]] Number off_surface(const ExactVector& point, const Cylinder& cylinder);
[[nodiscard]] Number off_surface(const ExactVector& point, const Cone& cone);
[[nodiscard]] Number off_surface(const ExactVector& point, const OrientedBox& box);

/// An upper bound of the distance by which a ray that misses the shape must be moved to hit it,
/// given a point of the ray near the shape.
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Sphere& sphere);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Plane& plane);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Triangle& triangle);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Square& square);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Cylinder& cylinder);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const Cone& cone);
[[nodiscard]] Number gap(const Ray& ray, const ExactVector& near, const OrientedBox& box);

}  // namespace rt::oracle
