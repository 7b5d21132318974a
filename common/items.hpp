// The shapes of one kind in a scene.
#pragma once

#include "common/balls.hpp"
#include "common/bounds.hpp"
#include "common/copies.hpp"
#include "common/hierarchy.hpp"
#include "common/material.hpp"

#include <concepts>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace rt::inline RT_PRECISION {

/// A shape and what it is made of.
template <class Shape>
struct Item {
    Shape shape;
    Material material;
};

/// Whether a kind of shape fits into a box and a ball: all but the plane.
template <class Shape>
concept Bounded = requires(const Shape& shape) {
    { bounds(shape) } -> std::same_as<Box>;
    { ball_around(shape) } -> std::same_as<Ball>;
};

/// What rays are spared by.
struct Arrangement {
    static constexpr std::size_t never = ~std::size_t(0);

    std::optional<std::size_t> hierarchy_from;  ///< items of a kind; else from where it pays
    bool balls = true;  ///< around fewer, even around one (measured: docs/accuracy.md)
};

/// A list of items; around a few of them balls, or above many a hierarchy, so that a ray asks those
/// alone that it may meet.
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

    /// Whether they fit into boxes, and are so many that a hierarchy of these is wanted.
    [[nodiscard]] bool many(const Arrangement& how = {}) const {
        return Bounded<Shape> &&
               items_.size() >= how.hierarchy_from.value_or(hierarchy_pays_from<Shape>);
    }

    /// A hierarchy is in the frame of the scene, if there are others. Of shapes that are the same,
    /// the first stays: whatever they are made of, no ray meets another before it, and each would
    /// be tested for every ray that comes near.
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

    /// Whether there is a hierarchy.
    [[nodiscard]] bool arranged() const { return Bounded<Shape> && !hierarchy_.empty(); }

    /// Whether 64 bits have one for each, and no hierarchy is quicker.
    [[nodiscard]] bool is_short_list() const { return !arranged() && items_.size() <= Balls::most; }

    /// One for each, if there is no hierarchy; none, if they are not arranged.
    [[nodiscard]] const Balls& balls() const { return balls_; }

    /// Around all of them, if they fit into boxes; at once, if they are arranged.
    [[nodiscard]] Box box() const {
        Box all = hierarchy_.bounds();
        if constexpr (Bounded<Shape>)
            if (!arranged())
                for (const Item<Shape>& item : items_) all = united(all, bounds(item.shape));
        return all;
    }

    /// Calls visit(item) for every item that the ray may meet inside the interval; a visit may
    /// shorten the interval, and spares the items beyond.
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

    /// Whether visit(item) is true for any item that the ray may meet inside the interval.
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

}  // namespace rt::inline RT_PRECISION
