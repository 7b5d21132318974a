// The closest hit so far along a ray, decided by exact arithmetic.
#pragma once

#include "common/exact/exact_root.hpp"
#include "common/scene/mesh_instance.hpp"
#include "common/scene/primitives.hpp"

#include <cstdint>
#include <functional>
#include <type_traits>

namespace rt {
inline namespace RT_PRECISION {

/// Two rounded t with a larger relative difference are in their exact order: the error of every
/// certified kernel is at most 128 u of t.
inline constexpr Real undecided = 260 * unit_roundoff;

/// `Object` identifies what was hit. Its order decides between two hits at exactly the same t.
template <class Object>
class ClosestSoFar {
public:
    /// The t of the closest hit; infinite if there is none yet.
    [[nodiscard]] Real t() const { return t_; }
    [[nodiscard]] const Object& object() const { return object_; }

    /// Considers a hit on `object` at about t inside the interval. If it is closer, it becomes the
    /// closest hit, the interval ends where no closer hit is possible beyond it, and the function
    /// returns true. `root_of(object)` is the exact root, or nothing if it is not known.
    template <class RootOf>
    bool accepts(Real t, const Object& object, const RootOf& root_of, Interval& interval) {
        const bool certain = !(std::abs(t - t_) <= undecided * t);
        if (certain ? t >= t_ : !is_ahead(t, object, root_of)) return false;
        t_ = t;
        object_ = object;
        interval.max = t * (1 + undecided);
        return true;
    }

private:
    template <class RootOf>
    [[nodiscard, gnu::noinline]] bool is_ahead(Real t, const Object& object,
                                               const RootOf& root_of) const {
        const auto root = root_of(object);
        const auto root_of_leader = root_of(object_);
        if (!root || !root_of_leader) return t < t_;
        const int order = order_of(*root, *root_of_leader).value_or(0);
        return order != 0 ? order < 0 : object < object_;
    }

    Real t_ = infinity;
    Object object_;
};

}  // namespace RT_PRECISION

/// The exact root of the hit on the mesh's triangle of that index.
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const MeshInstance& instance,
                                                  std::uint32_t triangle, Interval interval);

inline namespace RT_PRECISION {

/// A primitive of a scene that was hit. For boxes no exact root is available.
struct HitItem {
    const void* primitive = nullptr;
    std::uint32_t triangle = 0;  ///< index of a mesh's triangle
    std::optional<ExactRoot> (*root)(const Ray&, const HitItem&) = nullptr;

    /// Between two kinds, the one that is tested first stays the closest.
    friend bool operator<(const HitItem& a, const HitItem& b) {
        return a.root == b.root && std::less<>()(a.primitive, b.primitive);
    }
};

class ClosestPrimitive {
public:
    /// The t of the closest hit, before the end of the interval of the query.
    [[nodiscard]] Real t(const Interval& /*interval*/) const { return leader_.t(); }

    /// Considers a hit inside the interval, and returns whether it is the closest one.
    template <class Shape>
    [[nodiscard]] bool accepts(const Ray& ray, const Primitive<Shape>& primitive, Real t,
                               Interval& interval) {
        return accepts(ray, {.primitive = &primitive, .root = &root_of<Shape>}, t, interval);
    }

    [[nodiscard]] bool accepts(const Ray& ray, const Primitive<MeshInstance>& primitive,
                               const MeshHit& hit, Interval& interval) {
        return accepts(
            ray,
            {.primitive = &primitive, .triangle = hit.triangle, .root = &root_of<MeshInstance>},
            hit.t, interval);
    }

private:
    bool accepts(const Ray& ray, const HitItem& hit, Real t, Interval& interval) {
        return leader_.accepts(
            t, hit, [&ray](const HitItem& one) { return one.root(ray, one); }, interval);
    }

    template <class Shape>
    static std::optional<ExactRoot> root_of(const Ray& ray, const HitItem& hit) {
        const Shape& shape = static_cast<const Primitive<Shape>*>(hit.primitive)->shape;
        if constexpr (std::is_same_v<Shape, MeshInstance>)
            return exact_root(ray, shape, hit.triangle, {});
        else if constexpr (requires { exact_root(ray, shape, Interval()); })
            return exact_root(ray, shape, {});
        else
            return std::nullopt;
    }

    ClosestSoFar<HitItem> leader_;
};

}  // namespace RT_PRECISION
}  // namespace rt
