// The nearest of what a ray has met so far, as exact arithmetic has it.
#pragma once

#include "common/exact/exact_root.hpp"
#include "common/items.hpp"
#include "common/placed_mesh.hpp"

#include <cstdint>
#include <functional>
#include <type_traits>

namespace rt::inline RT_PRECISION {

/// Two rounded t that are further apart tell which is smaller: no certified kernel's is further
/// than 128 u of itself from the exact one.
inline constexpr Real undecided = 260 * unit_roundoff;

/// `Met` is what was met, in the order in which the first wins if both are equally near.
template <class Met>
class Leader {
public:
    /// Infinite before there is one.
    [[nodiscard]] Real t() const { return t_; }
    [[nodiscard]] const Met& met() const { return met_; }

    /// Whether something else, met in the interval at about t, is nearer; then it leads, and the
    /// interval ends where nothing beyond it can be. `root_of(met)` is the exact root, if one is
    /// known.
    template <class RootOf>
    bool yields_to(Real t, const Met& met, const RootOf& root_of, Interval& interval) {
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

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// Of the mesh's triangle of that index.
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const PlacedMesh& placed,
                                                  std::uint32_t triangle, Interval interval);

}  // namespace rt

namespace rt::inline RT_PRECISION {

/// An item of a scene that was met. Nothing is known of how boxes are met exactly.
struct MetItem {
    const void* item = nullptr;
    std::uint32_t triangle = 0;  ///< of a mesh
    std::optional<ExactRoot> (*root)(const Ray&, const MetItem&) = nullptr;

    /// Of two kinds, the one that is looked through first keeps the lead.
    friend bool operator<(const MetItem& a, const MetItem& b) {
        return a.root == b.root && std::less<>()(a.item, b.item);
    }
};

/// The nearest item of a scene.
class LeadingItem {
public:
    [[nodiscard]] Real t() const { return leader_.t(); }

    template <class Shape>
    [[nodiscard]] bool yields_to(const Ray& ray, const Item<Shape>& item, Real t,
                                 Interval& interval) {
        return yields_to(ray, {.item = &item, .root = &root_of<Shape>}, t, interval);
    }

    [[nodiscard]] bool yields_to(const Ray& ray, const Item<PlacedMesh>& item, const MeshHit& hit,
                                 Interval& interval) {
        return yields_to(ray,
                         {.item = &item, .triangle = hit.triangle, .root = &root_of<PlacedMesh>},
                         hit.t, interval);
    }

private:
    bool yields_to(const Ray& ray, const MetItem& met, Real t, Interval& interval) {
        return leader_.yields_to(
            t, met, [&ray](const MetItem& one) { return one.root(ray, one); }, interval);
    }

    template <class Shape>
    static std::optional<ExactRoot> root_of(const Ray& ray, const MetItem& met) {
        const Shape& shape = static_cast<const Item<Shape>*>(met.item)->shape;
        if constexpr (std::is_same_v<Shape, PlacedMesh>)
            return exact_root(ray, shape, met.triangle, {});
        else if constexpr (requires { exact_root(ray, shape, Interval()); })
            return exact_root(ray, shape, {});
        else
            return std::nullopt;
    }

    Leader<MetItem> leader_;
};

}  // namespace rt::inline RT_PRECISION
