// The closest hit of a ray among all shapes (M1, "plusieurs objets"; CR §2.1), and the any-hit
// query (CR §3.2).
#pragma once

#include "common/explain/pixel_log.hpp"
#include "common/geometry/projection.hpp"
#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"
#include "common/render/context.hpp"
#include "common/render/surface.hpp"
#include "common/scene/scene.hpp"

#ifdef RT_EXACT
#include "common/exact/leader.hpp"
#endif

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {

/// The closest hit of a ray.
struct Hit {
    Real t;
    Vec3 point;   ///< projected onto the surface
    Real error;   ///< upper bound on the distance from the point to the surface
    Vec3 normal;  ///< outward, unit length; interpolated if the mesh has normals
    Vec3 side;    ///< geometric normal: as normal, but never interpolated
    const Material* material;

    Hit(Real t_of_hit, const SurfacePoint& place, Vec3 its_normal, Vec3 its_side,
        const Material& its_material)
        : t(t_of_hit),
          point(place.point),
          error(place.error),
          normal(its_normal),
          side(its_side),
          material(&its_material) {}
};

/// The shading point at the hit, seen from the ray's origin: both normals are on the side of the
/// eye.
inline Surface surface_at(const Hit& hit, const Ray& ray) {
    const bool outside = dot(hit.side, ray.direction) <= 0;
    return {.point = hit.point,
            .normal = outside ? hit.normal : -hit.normal,
            .side = outside ? hit.side : -hit.side,
            .to_eye = unit(-ray.direction),
            .error = hit.error,
            .material = *hit.material};
}

/// The t of a result of `intersect`, which is a t or a MeshHit.
inline std::optional<Real> t_of(std::optional<Real> answer) {
    return answer;
}
inline std::optional<Real> t_of(const std::optional<MeshHit>& answer) {
    if (!answer) return std::nullopt;
    return answer->t;
}

/// The closest-hit query of a ray: finds the smallest t in lists of shapes. Every hit shortens the
/// interval, so that `intersect` accepts later shapes only if they are closer. The point and the
/// normal are computed once, for the closest hit. Each kind of shape uses `intersect` and `normal`
/// of its own stage. The ray must outlive the query.
class Nearest {
public:
    Nearest(const Ray& ray, Context& context) : ray_(ray), slabs_(ray), story_(context.story) {
        ++context.rays;
    }

    template <class Shape>
    void among(const Items<Shape>& items) {
        // The rest is not inlined here, so that an empty list costs one branch. Inside that
        // function everything is inlined, `intersect` included, in a unity build
        // (common/cmake/stage.cmake).
        if (items.empty()) return;
        if (story_ == nullptr)
            among_some(items);
        else
            tell_among(items);
    }

    /// The closest hit in the lists tested so far, or nothing.
    [[nodiscard]] std::optional<Hit> hit() const {
        if (winner_ == nullptr) return std::nullopt;
        const std::optional<Hit> hit = describe_(*this);
        if (story_ != nullptr) tell_hit(*story_, hit->point, hit->normal);
        return hit;
    }

private:
    template <class Shape>
    [[gnu::noinline, gnu::flatten]] void among_some(const Items<Shape>& items) {
        items.along(slabs_, interval_, [this](const Item<Shape>& item) {
            keep(item, intersect(ray_, item.shape, interval_));
        });
    }

    /// Logs the misses too, which a hierarchy would skip.
    template <class Shape>
    [[gnu::noinline]] void tell_among(const Items<Shape>& items) {
        for (const Item<Shape>& item : items) {
            const auto answer = intersect(ray_, item.shape, interval_);
            tell_candidate(*story_, ray_, item.shape, interval_, t_of(answer));
            keep(item, answer);
        }
    }

    template <class Shape, class Answer>
    void keep(const Item<Shape>& item, const Answer& answer) {
        if (!answer) return;
#ifdef RT_EXACT
        if (!leader_.yields_to(ray_, item, *answer, interval_)) return;
#else
        interval_.max = *t_of(answer);
#endif
        if constexpr (std::is_same_v<Shape, PlacedMesh>) in_mesh_ = *answer;
        winner_ = &item;
        describe_ = &describe<Shape>;
    }

#ifdef RT_EXACT
    [[nodiscard]] Real t() const {
        return leader_.t();
    }
    LeadingItem leader_;
#else
    [[nodiscard]] Real t() const {
        return interval_.max;
    }
#endif

    template <class Shape>
    [[gnu::flatten]] static std::optional<Hit> describe(const Nearest& nearest) {
        const auto& [shape, material] = *static_cast<const Item<Shape>*>(nearest.winner_);
        const Real t = nearest.t();
        // Constructed in place, so that nothing is copied.
        if constexpr (std::is_same_v<Shape, PlacedMesh>) {
            const MeshHit& hit = *nearest.in_mesh_;
            return std::optional<Hit>(std::in_place, t, projected(shape, hit), normal(shape, hit),
                                      side(shape, hit), material);
        } else {
            const SurfacePoint place = projected(shape, at(nearest.ray_, t));
            const Vec3 side = normal(shape, place.point);
            return std::optional<Hit>(std::in_place, t, place, side, side, material);
        }
    }

    const Ray& ray_;
    SlabTests slabs_;
    Story* story_;
    Interval interval_;
    std::optional<MeshHit> in_mesh_;  ///< set if the closest hit is on a mesh
    const void* winner_ = nullptr;
    std::optional<Hit> (*describe_)(const Nearest&) = nullptr;
};

/// Returns whether the ray hits the shape anywhere strictly inside the interval. For a mesh this is
/// faster than the closest hit.
template <class Shape>
bool blocks(const Ray& ray, const Shape& shape, Interval interval) {
    return intersect(ray, shape, interval).has_value();
}

/// The any-hit query of a ray: tests lists of shapes for any hit inside the interval, and stops at
/// the first one found. The ray must outlive the query.
class Blocker {
public:
    Blocker(const Ray& ray, Interval interval, Context& context)
        : ray_(ray), slabs_(ray), interval_(interval), story_(context.story) {
        ++context.rays;
    }

    template <class Shape>
    void among(const Items<Shape>& items) {
        if (!items.empty() && !found_) found_ = among_some(items);
    }

    /// Tests only the primitives of a short list whose bit in `chosen` is set.
    template <class Shape>
    void among(const Items<Shape>& items, std::uint64_t chosen) {
        if (!items.is_short_list()) return among(items);
        while (chosen != 0 && !found_) found_ = is_in_the_way(items[take_lowest(chosen)]);
    }

    [[nodiscard]] bool found() const { return found_; }

private:
    template <class Shape>
    [[nodiscard, gnu::noinline, gnu::flatten]] bool among_some(const Items<Shape>& items) {
        return items.any_along(slabs_, interval_,
                               [this](const Item<Shape>& item) { return is_in_the_way(item); });
    }

    template <class Shape>
    [[nodiscard]] bool is_in_the_way(const Item<Shape>& item) {
        const bool in_the_way = blocks(ray_, item.shape, interval_);
        if (in_the_way && story_ != nullptr) tell(item.shape);
        return in_the_way;
    }

    template <class Shape>
    [[gnu::noinline]] void tell(const Shape& shape) {
        story_->remark("in the way: " + code(shape));
    }

    const Ray& ray_;
    SlabTests slabs_;
    Interval interval_;
    Story* story_;
    bool found_ = false;
};

}  // namespace RT_PRECISION
}  // namespace rt
