// The shapes of one kind in a scene.
#pragma once

#include "common/bounds.hpp"
#include "common/hierarchy.hpp"
#include "common/material.hpp"

#include <concepts>
#include <initializer_list>
#include <utility>
#include <vector>

namespace rt::inline RT_PRECISION {

/// A shape and what it is made of.
template <class Shape>
struct Item {
    Shape shape;
    Material material;
};

/// Whether a kind of shape fits into a box: all but the plane.
template <class Shape>
concept Bounded = requires(const Shape& shape) {
    { bounds(shape) } -> std::same_as<Box>;
};

/// A list of items, and above many of them a hierarchy, so that a ray asks those alone whose boxes
/// it meets.
template <class Shape>
class Items {
public:
    Items() = default;
    Items(std::initializer_list<Item<Shape>> items) : items_(items) {}
    explicit Items(std::vector<Item<Shape>> items) : items_(std::move(items)) {}

    void push_back(const Item<Shape>& item) {
        items_.push_back(item);
        hierarchy_ = {};
    }

    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] const Item<Shape>& operator[](std::size_t index) const { return items_[index]; }
    [[nodiscard]] const Item<Shape>& at(std::size_t index) const { return items_.at(index); }
    [[nodiscard]] const Item<Shape>& front() const { return items_.front(); }
    [[nodiscard]] const Item<Shape>& back() const { return items_.back(); }
    [[nodiscard]] auto begin() const { return items_.begin(); }
    [[nodiscard]] auto end() const { return items_.end(); }

    /// Whether they fit into boxes, and are so many that a hierarchy of these pays.
    [[nodiscard]] bool worth_arranging(std::size_t pays_from = hierarchy_pays_from) const {
        return Bounded<Shape> && items_.size() >= pays_from;
    }

    /// Builds the hierarchy, if it pays; in the frame of the scene, if there are others.
    void arrange(std::size_t pays_from = hierarchy_pays_from, const Box& scene = {}) {
        hierarchy_ = {};
        if constexpr (Bounded<Shape>) {
            if (!worth_arranging(pays_from)) return;
            std::vector<Box> boxes;
            boxes.reserve(items_.size());
            for (const Item<Shape>& item : items_) boxes.push_back(bounds(item.shape));
            hierarchy_ = Hierarchy(boxes, Hierarchy::Leaves::one_by_one, scene);
        }
    }

    [[nodiscard]] bool arranged() const { return !hierarchy_.empty(); }

    /// Whether 64 bits have one for each, and no hierarchy is quicker.
    [[nodiscard]] bool is_short_list() const { return !arranged() && items_.size() <= 64; }

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
        if (!arranged()) {
            for (const Item<Shape>& item : items_) visit(item);
        } else {
            hierarchy_.nearest(ray, interval, [&](std::size_t index) { visit(items_[index]); });
        }
    }

    /// Whether visit(item) is true for any item that the ray may meet inside the interval.
    template <class Visit>
    [[nodiscard]] bool any_along(SlabTests& ray, Interval interval, Visit visit) const {
        if (!arranged()) {
            for (const Item<Shape>& item : items_)
                if (visit(item)) return true;
            return false;
        }
        return hierarchy_.any(ray, interval,
                              [&](std::size_t index) { return visit(items_[index]); });
    }

private:
    std::vector<Item<Shape>> items_;
    Hierarchy hierarchy_;
};

}  // namespace rt::inline RT_PRECISION
