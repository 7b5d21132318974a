// What may stand between a point and a light with a size: of most shapes one look tells for all of
// the light's rays that it does not.
#pragma once

#include "common/nearest.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace rt::inline RT_PRECISION {

/// The convex hull of a point and a ball, which no ray from the one to the other leaves (Haines and
/// Wallace 1991, "Shaft Culling for Efficient Ray-Traced Radiosity").
class Shaft {
public:
    Shaft(Vec3 point, const Light& light);

    /// False only if it stays out by more than its rounded test can be wrong.
    template <class Shape>
    [[nodiscard]] bool may_hold(const Shape& shape) const {
        return may_hold(bounds(shape));
    }
    [[nodiscard]] bool may_hold(const Box& box) const;
    [[nodiscard]] bool may_hold(const Sphere& sphere) const;
    [[nodiscard]] bool may_hold(const Plane& plane) const;
    [[nodiscard]] bool may_hold(const Triangle& triangle) const;
    [[nodiscard]] bool may_hold(const Square& square) const;

private:
    /// Whether it lies on one side of a plane. The normal, of any length, may be off by its error.
    [[nodiscard]] bool beside_plane(Vec3 in_plane, Vec3 normal, Real normal_error) const;
    [[nodiscard]] bool beside_ball(Vec3 center, Real radius) const;
    /// In units of u times the largest coordinate.
    [[nodiscard]] Real roundings(Real units, Real largest) const;

    Vec3 point_;
    Vec3 center_;
    Real radius_;
    Box bounds_;
    Real size_;        ///< its largest coordinate
    Vec3 axis_{0};     ///< unit length, to the ball
    Real sine_ = 0;    ///< of the angle between the axis and the side
    Real cosine_ = 0;  ///< 0 if the point is in the ball: then there is no side
};

/// The shapes of a scene that a shaft may hold. It looks through the scene's lists once, and its
/// Blocker through the same ones in the same order.
class Suspects {
public:
    explicit Suspects(const Shaft& shaft) : shaft_(shaft) {}

    template <class Shape>
    void among(const Items<Shape>& items) {
        if (!items.empty()) look_through(items);
        ++kinds_;
    }

    [[nodiscard]] bool none() const { return none_; }

    /// As rt::Blocker, of these shapes.
    class Blocker {
    public:
        Blocker(const Ray& ray, Interval interval, const Suspects& suspects, Context& context)
            : all_(ray, interval, context), masks_(suspects.masks_.data()) {}

        template <class Shape>
        void among(const Items<Shape>& items) {
            if (const std::uint64_t mask = *masks_++; mask != 0) all_.among(items, mask);
        }

        [[nodiscard]] bool found() const { return all_.found(); }

    private:
        rt::Blocker all_;
        const std::uint64_t* masks_;
    };

private:
    static constexpr std::size_t most_kinds = 8;

    template <class Shape>
    [[gnu::noinline]] void look_through(const Items<Shape>& items) {
        std::uint64_t& mask = masks_[kinds_];
        if (is_short_list(items)) {
            for (std::size_t i = 0; i < items.size(); ++i)
                mask |= std::uint64_t(shaft_.may_hold(items[i].shape)) << i;
        } else {
            mask = items.arranged() && !shaft_.may_hold(items.box()) ? 0 : ~std::uint64_t(0);
        }
        none_ = none_ && mask == 0;
    }

    const Shaft& shaft_;
    std::array<std::uint64_t, most_kinds> masks_{};
    std::size_t kinds_ = 0;
    bool none_ = true;
};

}  // namespace rt::inline RT_PRECISION
