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

/// `Met` identifies the hit object. Its order decides between two hits at exactly the same t.
template <class Met>
class ClosestSoFar {
public:
    /// The t of the closest hit; infinite if there is none yet.
    [[nodiscard]] Real t() const { return t_; }
    [[nodiscard]] const Met& met() const { return met_; }

    /// Considers a hit on `met` at about t inside the interval. If it is closer, it becomes the
    /// closest hit, the interval ends where no closer hit is possible beyond it, and the function
    /// returns true. `root_of(met)` is the exact root, or nothing if it is not known.
    template <class RootOf>
    bool accepts(Real t, const Met& met, const RootOf& root_of, Interval& interval) {
        const bool told = !(std::abs(t - t_) <= undecided * t);
        if (told ? t >= t_ : !is_ahead(t, met, root_of)) return false;
        t_ = t;
        met_ = met;
        interval.max = t * (1 + undecided);
        return true;
    }

private:
    template <class RootOf>
    [[nodiscard, gnu::noinline]] bool is_ahead(Real t, const Met& met,
                                               const RootOf& root_of) const {
        const auto root = root_of(met);
        const auto root_of_leader = root_of(met_);
        if (!root || !root_of_leader) return t < t_;
        const int order = order_of(*root, *root_of_leader).value_or(0);
        return order != 0 ? order < 0 : met < met_;
    }

    Real t_ = infinity;
    Met met_;
};

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The exact root of the hit on the mesh's triangle of that index.
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const MeshInstance& instance,
                                                  std::uint32_t triangle, Interval interval);

}  // namespace rt

namespace rt {
inline namespace RT_PRECISION {

/// A primitive of a scene that was hit. For boxes no exact root is available.
struct MetItem {
    const void* primitive = nullptr;
    std::uint32_t triangle = 0;  ///< index of a mesh's triangle
    std::optional<ExactRoot> (*root)(const Ray&, const MetItem&) = nullptr;

    /// Between two kinds, the one that is tested first stays the closest.
    friend bool operator<(const MetItem& a, const MetItem& b) {
        return a.root == b.root && std::less<>()(a.primitive, b.primitive);
    }
};

/// The closest primitive of a scene.
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
    bool accepts(const Ray& ray, const MetItem& met, Real t, Interval& interval) {
        return leader_.accepts(
            t, met, [&ray](const MetItem& one) { return one.root(ray, one); }, interval);
    }

    template <class Shape>
    static std::optional<ExactRoot> root_of(const Ray& ray, const MetItem& met) {
        const Shape& shape = static_cast<const Primitive<Shape>*>(met.primitive)->shape;
        if constexpr (std::is_same_v<Shape, MeshInstance>)
            return exact_root(ray, shape, met.triangle, {});
        else if constexpr (requires { exact_root(ray, shape, Interval()); })
            return exact_root(ray, shape, {});
        else
            return std::nullopt;
    }

    ClosestSoFar<MetItem> leader_;
};

}  // namespace RT_PRECISION
}  // namespace rt
