// Shaft culling for area lights: one test for each shape excludes it for every shadow ray from a
// point to the light.
#pragma once

#include "common/render/closest_hit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rt {
inline namespace RT_PRECISION {

/// The convex hull of a point and a sphere. It contains every ray from the point to the sphere
/// (Haines and Wallace 1991, "Shaft Culling for Efficient Ray-Traced Radiosity").
class Shaft {
public:
    Shaft(Vec3 point, const Light& light);

    /// Returns false only if the shape is outside the shaft by more than the error of its rounded
    /// intersection test.
    template <class Shape>
    [[nodiscard]] bool may_intersect(const Shape& shape) const {
        return may_intersect(bounds(shape));
    }
    [[nodiscard]] bool may_intersect(const BoundingBox& box) const;
    [[nodiscard]] bool may_intersect(const BoundingSphere& ball) const;
    [[nodiscard]] bool may_intersect(const Sphere& sphere) const;
    [[nodiscard]] bool may_intersect(const Plane& plane) const;
    [[nodiscard]] bool may_intersect(const Triangle& triangle) const;
    [[nodiscard]] bool may_intersect(const Square& square) const;

private:
    /// Returns whether the whole shaft lies on one side of a plane. The normal, of any length, has
    /// an error of at most `normal_error`.
    [[nodiscard]] bool beside_plane(Vec3 in_plane, Vec3 normal, Real normal_error) const;
    [[nodiscard]] bool beside_ball(Vec3 center, Real radius) const;
    /// A padding of `units` roundings: units · u · the largest coordinate.
    [[nodiscard]] Real roundings(Real units, Real largest) const;

    Vec3 point_;
    Vec3 center_;
    Real radius_;
    BoundingBox bounds_;
    Real size_;      ///< largest coordinate of the shaft
    Vec3 axis_{0};   ///< unit length, toward the center of the light
    Real sine_ = 0;  ///< sine of the angle between the axis and the side
    Real cosine_ =
        0;  ///< its cosine; 0 if the point is in the light's sphere, where the shaft has no side
};

/// The potential occluders: the shapes of a scene that may intersect a shaft.
class PotentialOccluders {
public:
    explicit PotentialOccluders(const Shaft& shaft) : shaft_(shaft) {}

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (!primitives.empty()) collect(primitives);
    }

    [[nodiscard]] bool none() const { return count_ == 0; }

    /// Returns whether the ray, which must stay in the shaft, hits one of the shapes inside the
    /// interval.
    [[nodiscard]] bool block(const Ray& ray, Interval interval, Context& context) const {
        AnyHit any_hit(ray, interval, context);
        for (std::size_t i = 0; i < count_ && !any_hit.found(); ++i)
            kinds_[i].ask(any_hit, kinds_[i]);
        return any_hit.found();
    }

private:
    /// The potential occluders of one kind: in a short list, the primitives whose bit is set;
    /// otherwise the whole list.
    struct Kind {
        const void* primitives;
        std::uint64_t chosen;
        void (*ask)(AnyHit& any_hit, const Kind& kind);
    };

    template <class Shape>
    static void ask(AnyHit& any_hit, const Kind& kind) {
        any_hit.test(*static_cast<const PrimitiveList<Shape>*>(kind.primitives), kind.chosen);
    }

    /// Defined in queries.hpp.
    template <class Shape>
    void collect(const PrimitiveList<Shape>& primitives);

    const Shaft& shaft_;
    std::array<Kind, list_count> kinds_;  ///< each list is looked through once
    std::size_t count_ = 0;
};

}  // namespace RT_PRECISION
}  // namespace rt
