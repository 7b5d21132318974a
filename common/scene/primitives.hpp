// A list of the primitives of one kind of shape in a scene, with its acceleration structure.
#pragma once

#include "common/bvh/bvh.hpp"
#include "common/bvh/sphere_packet.hpp"
#include "common/geometry/bounds.hpp"
#include "common/scene/copies.hpp"
#include "common/scene/material.hpp"

#include <concepts>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

/// A primitive: a shape and its material.
template <class Shape>
struct Item {
    Shape shape;
    Material material;
};

/// A kind of shape that has a bounding box and a bounding sphere: every kind except the plane.
template <class Shape>
concept Bounded = requires(const Shape& shape) {
    { bounds(shape) } -> std::same_as<Box>;
    { ball_around(shape) } -> std::same_as<Ball>;
};

/// The choice of acceleration structures.
struct Arrangement {
    static constexpr std::size_t never = ~std::size_t(0);

    std::optional<std::size_t>
        hierarchy_from;  ///< smallest list for a hierarchy; nothing for the measured default
    bool balls = true;   ///< bounding spheres around shorter lists, even a single shape (measured:
                         ///< docs/reference/accuracy.md)
};

/// A list of primitives. A short list has bounding spheres and a long one a bounding volume
/// hierarchy, so that a ray is tested only against the primitives that it may hit.
template <class Shape>
class Items {
public:
    Items() = default;
    Items(std::initializer_list<Item<Shape>> items) : items_(items) {}
    explicit Items(std::vector<Item<Shape>> items) : items_(std::move(items)) {}

    void push_back(const Item<Shape>& item) {
        items_.push_back(item);
        disarrange();
    }

    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] const Item<Shape>& operator[](std::size_t index) const { return items_[index]; }
    [[nodiscard]] const Item<Shape>& at(std::size_t index) const { return items_.at(index); }
    [[nodiscard]] const Item<Shape>& front() const { return items_.front(); }
    [[nodiscard]] const Item<Shape>& back() const { return items_.back(); }
    [[nodiscard]] auto begin() const { return items_.begin(); }
    [[nodiscard]] auto end() const { return items_.end(); }

    /// Returns whether the shapes have bounding boxes, and are numerous enough for a hierarchy.
    [[nodiscard]] bool many(const Arrangement& how = {}) const {
        return Bounded<Shape> &&
               items_.size() >= how.hierarchy_from.value_or(hierarchy_pays_from<Shape>);
    }

    /// Builds the acceleration structure. A hierarchy uses the frame around `scene`, if there are
    /// other hierarchies. Of equal shapes only the first stays: no ray hits another one before it,
    /// whatever its material, and each copy would cost a test for every ray nearby.
    void arrange(const Arrangement& how = {}, const Box& scene = {}) {
        disarrange();
        if constexpr (Bounded<Shape>) {
            if (many(how))
                leave_out_copies(
                    items_,
                    [](const Item<Shape>& item) {
                        const Box box = bounds(item.shape);
                        return hash({box.min, box.max});
                    },
                    [](const Item<Shape>& a, const Item<Shape>& b) { return a.shape == b.shape; });
            if (many(how))
                hierarchy_ = Hierarchy(
                    items_.size(), [this](std::size_t i) { return bounds(items_[i].shape); },
                    Hierarchy::Leaves::one_by_one, scene);
            else if (how.balls && items_.size() <= Balls::most)
                balls_ = in_balls();
        }
    }

    /// Returns whether the list has a hierarchy.
    [[nodiscard]] bool arranged() const { return Bounded<Shape> && !hierarchy_.empty(); }

    /// Returns whether a 64-bit mask has a bit for every primitive, and the list has no hierarchy.
    [[nodiscard]] bool is_short_list() const { return !arranged() && items_.size() <= Balls::most; }

    /// The bounding spheres, one for each primitive; empty if there is a hierarchy, or no
    /// acceleration structure was built.
    [[nodiscard]] const Balls& balls() const { return balls_; }

    /// The bounding box of all primitives, if the shapes have bounding boxes. Takes constant time
    /// if there is a hierarchy.
    [[nodiscard]] Box box() const {
        Box all = hierarchy_.bounds();
        if constexpr (Bounded<Shape>)
            if (!arranged())
                for (const Item<Shape>& item : items_) all = united(all, bounds(item.shape));
        return all;
    }

    /// Calls visit(item) for every primitive that the ray may hit inside the interval. A visit may
    /// shorten the interval, and primitives beyond it may be skipped.
    template <class Visit>
    void along(SlabTests& ray, Interval& interval, Visit visit) const {
        if (arranged()) {
            hierarchy_.nearest(ray, interval, [&](std::size_t index) { visit(items_[index]); });
        } else if (has_balls()) {
            for (std::uint64_t near = balls_.near(ray.ray()); near != 0;)
                visit(items_[take_lowest(near)]);
        } else {
            for (const Item<Shape>& item : items_) visit(item);
        }
    }

    /// Returns whether visit(item) is true for any primitive that the ray may hit inside the
    /// interval.
    template <class Visit>
    [[nodiscard]] bool any_along(SlabTests& ray, Interval interval, Visit visit) const {
        if (arranged())
            return hierarchy_.any(ray, interval,
                                  [&](std::size_t index) { return visit(items_[index]); });
        if (has_balls()) {
            for (std::uint64_t near = balls_.near(ray.ray()); near != 0;)
                if (visit(items_[take_lowest(near)])) return true;
            return false;
        }
        for (const Item<Shape>& item : items_)
            if (visit(item)) return true;
        return false;
    }

private:
    [[nodiscard]] bool has_balls() const { return Bounded<Shape> && !balls_.empty(); }

    [[nodiscard]] Balls in_balls() const {
        std::vector<Ball> balls;
        for (const Item<Shape>& item : items_) balls.push_back(ball_around(item.shape));
        return Balls(balls);
    }

    void disarrange() {
        hierarchy_ = {};
        balls_ = {};
    }

    std::vector<Item<Shape>> items_;
    Balls balls_;
    Hierarchy hierarchy_;
};

}  // namespace RT_PRECISION
}  // namespace rt
