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
    [[nodiscard]] bool may_hold(const Shape& shape) const {
        return may_hold(bounds(shape));
    }
    [[nodiscard]] bool may_hold(const Box& box) const;
    [[nodiscard]] bool may_hold(const Ball& ball) const;
    [[nodiscard]] bool may_hold(const Sphere& sphere) const;
    [[nodiscard]] bool may_hold(const Plane& plane) const;
    [[nodiscard]] bool may_hold(const Triangle& triangle) const;
    [[nodiscard]] bool may_hold(const Square& square) const;

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
    Box bounds_;
    Real size_;      ///< largest coordinate of the shaft
    Vec3 axis_{0};   ///< unit length, toward the center of the light
    Real sine_ = 0;  ///< sine of the angle between the axis and the side
    Real cosine_ =
        0;  ///< its cosine; 0 if the point is in the light's sphere, where the shaft has no side
};

/// The potential occluders: the shapes of a scene that may intersect a shaft.
class Suspects {
public:
    explicit Suspects(const Shaft& shaft) : shaft_(shaft) {}

    template <class Shape>
    void among(const Items<Shape>& items) {
        if (!items.empty()) look_through(items);
    }

    [[nodiscard]] bool none() const { return count_ == 0; }

    /// Returns whether the ray, which must stay in the shaft, hits one of the shapes inside the
    /// interval.
    [[nodiscard]] bool block(const Ray& ray, Interval interval, Context& context) const {
        Blocker blocker(ray, interval, context);
        for (std::size_t i = 0; i < count_ && !blocker.found(); ++i)
            kinds_[i].ask(blocker, kinds_[i]);
        return blocker.found();
    }

private:
    /// The potential occluders of one kind: in a short list, the primitives whose bit is set;
    /// otherwise the whole list.
    struct Kind {
        const void* items;
        std::uint64_t chosen;
        void (*ask)(Blocker& blocker, const Kind& kind);
    };

    template <class Shape>
    static void ask(Blocker& blocker, const Kind& kind) {
        blocker.among(*static_cast<const Items<Shape>*>(kind.items), kind.chosen);
    }

    template <class Shape>
    [[gnu::noinline]] void look_through(const Items<Shape>& items) {
        std::uint64_t chosen = 0;
        if (items.is_short_list()) {
            // The test of the bounding sphere is faster, and usually decides.
            const Balls& balls = items.balls();
            for (std::size_t i = 0; i < items.size(); ++i) {
                const bool held =
                    (balls.empty() || shaft_.may_hold(balls[i])) && shaft_.may_hold(items[i].shape);
                chosen |= std::uint64_t(held) << i;
            }
        } else {
            chosen = !items.arranged() || shaft_.may_hold(items.box()) ? 1 : 0;
        }
        if (chosen != 0) kinds_[count_++] = {.items = &items, .chosen = chosen, .ask = &ask<Shape>};
    }

    const Shaft& shaft_;
    std::array<Kind, list_count> kinds_;  ///< each list is looked through once
    std::size_t count_ = 0;
};

}  // namespace RT_PRECISION
}  // namespace rt
