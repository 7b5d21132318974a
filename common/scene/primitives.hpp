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
struct Primitive {
    Shape shape;
    Material material;
};

/// A kind of shape that has a bounding box and a bounding sphere: every kind except the plane.
template <class Shape>
concept Bounded = requires(const Shape& shape) {
    { bounds(shape) } -> std::same_as<BoundingBox>;
    { bounding_sphere(shape) } -> std::same_as<BoundingSphere>;
};

/// The choice of acceleration structures.
struct Acceleration {
    static constexpr std::size_t never = ~std::size_t(0);

    std::optional<std::size_t>
        hierarchy_from;  ///< smallest list for a hierarchy; nothing for the measured default
    bool balls = true;   ///< bounding spheres around shorter lists, even a single shape (measured:
                         ///< docs/reference/accuracy.md)
};

/// A list of primitives. A short list has bounding spheres and a long one a bounding volume
/// hierarchy, so that a ray is tested only against the primitives that it may hit.
template <class Shape>
class PrimitiveList {
public:
    PrimitiveList() = default;
    PrimitiveList(std::initializer_list<Primitive<Shape>> primitives) : primitives_(primitives) {}
    explicit PrimitiveList(std::vector<Primitive<Shape>> primitives)
        : primitives_(std::move(primitives)) {}

    void push_back(const Primitive<Shape>& primitive) {
        primitives_.push_back(primitive);
        drop_acceleration();
    }

    [[nodiscard]] bool empty() const { return primitives_.empty(); }
    [[nodiscard]] std::size_t size() const { return primitives_.size(); }
    [[nodiscard]] const Primitive<Shape>& operator[](std::size_t index) const {
        return primitives_[index];
    }
    [[nodiscard]] const Primitive<Shape>& at(std::size_t index) const {
        return primitives_.at(index);
    }
    [[nodiscard]] const Primitive<Shape>& front() const { return primitives_.front(); }
    [[nodiscard]] const Primitive<Shape>& back() const { return primitives_.back(); }
    [[nodiscard]] auto begin() const { return primitives_.begin(); }
    [[nodiscard]] auto end() const { return primitives_.end(); }

    /// Returns whether the shapes have bounding boxes, and are numerous enough for a hierarchy.
    [[nodiscard]] bool many(const Acceleration& how = {}) const {
        return Bounded<Shape> &&
               primitives_.size() >= how.hierarchy_from.value_or(bvh_pays_from<Shape>);
    }

    /// Builds the acceleration structure. A hierarchy uses the frame around `scene`, if there are
    /// other hierarchies. Of equal shapes only the first stays: no ray hits another one before it,
    /// whatever its material, and each copy would cost a test for every ray nearby.
    void build_acceleration(const Acceleration& how = {}, const BoundingBox& scene = {}) {
        drop_acceleration();
        if constexpr (Bounded<Shape>) {
            if (many(how))
                leave_out_copies(
                    primitives_,
                    [](const Primitive<Shape>& primitive) {
                        const BoundingBox box = bounds(primitive.shape);
                        return hash({box.min, box.max});
                    },
                    [](const Primitive<Shape>& a, const Primitive<Shape>& b) {
                        return a.shape == b.shape;
                    });
            if (many(how))
                hierarchy_ = Bvh(
                    primitives_.size(),
                    [this](std::size_t i) { return bounds(primitives_[i].shape); },
                    Bvh::Leaves::one_by_one, scene);
            else if (how.balls && primitives_.size() <= BoundingSphereSet::most)
                spheres_ = in_balls();
        }
    }

    /// Returns whether the list has a hierarchy.
    [[nodiscard]] bool has_bvh() const { return Bounded<Shape> && !hierarchy_.empty(); }

    /// Returns whether a 64-bit mask has a bit for every primitive, and the list has no hierarchy.
    [[nodiscard]] bool is_short_list() const {
        return !has_bvh() && primitives_.size() <= BoundingSphereSet::most;
    }

    /// The bounding spheres, one for each primitive; empty if there is a hierarchy, or no
    /// acceleration structure was built.
    [[nodiscard]] const BoundingSphereSet& balls() const { return spheres_; }

    /// The bounding box of all primitives, if the shapes have bounding boxes. Takes constant time
    /// if there is a hierarchy.
    [[nodiscard]] BoundingBox box() const {
        BoundingBox all = hierarchy_.bounds();
        if constexpr (Bounded<Shape>)
            if (!has_bvh())
                for (const Primitive<Shape>& primitive : primitives_)
                    all = merged(all, bounds(primitive.shape));
        return all;
    }

    /// Calls visit(item) for every primitive that the ray may hit inside the interval. A visit may
    /// shorten the interval, and primitives beyond it may be skipped.
    template <class Visit>
    void traverse(RayBoxTestCache& ray, Interval& interval, Visit visit) const {
        if (has_bvh()) {
            hierarchy_.nearest(ray, interval,
                               [&](std::size_t index) { visit(primitives_[index]); });
        } else if (has_balls()) {
            for (std::uint64_t near = spheres_.candidates(ray.ray()); near != 0;)
                visit(primitives_[pop_lowest_bit(near)]);
        } else {
            for (const Primitive<Shape>& primitive : primitives_) visit(primitive);
        }
    }

    /// Returns whether visit(item) is true for any primitive that the ray may hit inside the
    /// interval.
    template <class Visit>
    [[nodiscard]] bool traverse_any(RayBoxTestCache& ray, Interval interval, Visit visit) const {
        if (has_bvh())
            return hierarchy_.any(ray, interval,
                                  [&](std::size_t index) { return visit(primitives_[index]); });
        if (has_balls()) {
            for (std::uint64_t near = spheres_.candidates(ray.ray()); near != 0;)
                if (visit(primitives_[pop_lowest_bit(near)])) return true;
            return false;
        }
        for (const Primitive<Shape>& primitive : primitives_)
            if (visit(primitive)) return true;
        return false;
    }

private:
    [[nodiscard]] bool has_balls() const { return Bounded<Shape> && !spheres_.empty(); }

    [[nodiscard]] BoundingSphereSet in_balls() const {
        std::vector<BoundingSphere> balls;
        for (const Primitive<Shape>& primitive : primitives_)
            balls.push_back(bounding_sphere(primitive.shape));
        return BoundingSphereSet(balls);
    }

    void drop_acceleration() {
        hierarchy_ = {};
        spheres_ = {};
    }

    std::vector<Primitive<Shape>> primitives_;
    BoundingSphereSet spheres_;
    Bvh hierarchy_;
};

}  // namespace RT_PRECISION
}  // namespace rt
