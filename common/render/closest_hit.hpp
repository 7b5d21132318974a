// The closest hit of a ray among all shapes (M1, "plusieurs objets"; CR §2.1), and the any-hit
// query (CR §3.2).
#pragma once

#include "common/geometry/projection.hpp"
#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"
#include "common/render/context.hpp"
#include "common/render/leader.hpp"
#include "common/render/surface.hpp"
#include "common/render/watch.hpp"
#include "common/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace rt {
inline namespace RT_PRECISION {

/// The closest hit of a ray.
struct Hit {
    Real t;
    Vec3 point;             ///< projected onto the surface
    Real error;             ///< upper bound on the distance from the point to the surface
    Vec3 normal;            ///< outward, unit length; interpolated if the mesh has normals
    Vec3 geometric_normal;  ///< geometric normal: as normal, but never interpolated
    const Material* material;

    Hit(Real t_of_hit, const PointWithError& place, Vec3 its_normal, Vec3 its_geometric_normal,
        const Material& its_material)
        : t(t_of_hit),
          point(place.point),
          error(place.error),
          normal(its_normal),
          geometric_normal(its_geometric_normal),
          material(&its_material) {}
};

/// The shading point at the hit, seen from the ray's origin: both normals are on the side of the
/// eye.
inline ShadingPoint shading_point(const Hit& hit, const Ray& ray) {
    const bool outside = dot(hit.geometric_normal, ray.direction) <= 0;
    return {.point = hit.point,
            .normal = outside ? hit.normal : -hit.normal,
            .geometric_normal = outside ? hit.geometric_normal : -hit.geometric_normal,
            .to_eye = unit(-ray.direction),
            .error = hit.error,
            .material = *hit.material};
}

/// The normal of the shape at a point of it. A sphere, a cylinder or a cone whose radius is within
/// the error of the point has no normal there, as the point may be in its middle: that towards the
/// eye stands for it.
template <class Shape>
Vec3 normal_at(const Shape& shape, const PointWithError& place, Vec3 direction) {
    if constexpr (requires { shape.radius; })
        if (!(shape.radius > place.error)) [[unlikely]]
            return unit(-direction);
    return normal(shape, place.point);
}

/// The closest-hit query of a ray: finds the smallest t in lists of shapes. Every hit shortens the
/// interval, so that `intersect` accepts later shapes only if they are closer. The point and the
/// normal are computed once, for the closest hit. Each kind of shape uses `intersect` and `normal`
/// of its own stage. The ray must outlive the query.
class ClosestHit {
public:
    ClosestHit(const Ray& ray, Context& context) : ray_(ray), slabs_(ray), watch_(context.watch) {
        ++context.rays;
        if (watch_ != nullptr) [[unlikely]]
            watch_ray(context, ray);
    }

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (!primitives.empty()) test_list(primitives);
    }

    /// The closest hit in the lists tested so far, or nothing.
    [[nodiscard]] std::optional<Hit> hit() const {
        if (winner_ == nullptr) return std::nullopt;
        const std::optional<Hit> hit = describe_(*this);
        if (watch_ != nullptr) [[unlikely]]
            watch_hit(*watch_, ray_, winner_, hit->t, hit->point, hit->normal);
        return hit;
    }

private:
    /// Defined in queries.hpp.
    template <class Shape>
    void test_list(const PrimitiveList<Shape>& primitives);

    /// Tests the list as if it were not watched, after its watcher has looked at it.
    template <class Shape>
    [[gnu::noinline]] void test_watched(const PrimitiveList<Shape>& primitives) {
        const Watch* const watch = std::exchange(watch_, nullptr);
        watch_closest(*watch, ray_, interval_, leader_, primitives);
        test_list(primitives);
        watch_ = watch;
    }

    template <class Shape, class Answer>
    void keep(const Primitive<Shape>& primitive, const Answer& answer) {
        if (!answer || !leader_.accepts(ray_, primitive, *answer, interval_)) return;
        if constexpr (std::is_same_v<Shape, MeshInstance>) in_mesh_ = *answer;
        winner_ = &primitive;
        describe_ = &describe<Shape>;
    }

    template <class Shape>
    [[gnu::flatten]] static std::optional<Hit> describe(const ClosestHit& nearest) {
        const auto& [shape, material] = *static_cast<const Primitive<Shape>*>(nearest.winner_);
        const Real t = nearest.leader_.t(nearest.interval_);
        // Constructed in place, so that nothing is copied.
        if constexpr (std::is_same_v<Shape, MeshInstance>) {
            const MeshHit& hit = *nearest.in_mesh_;
            return std::optional<Hit>(std::in_place, t, snapped_to(shape, hit), normal(shape, hit),
                                      geometric_normal(shape, hit), material);
        } else {
            const PointWithError place = snapped_to(shape, at(nearest.ray_, t));
            const Vec3 geometric_normal = normal_at(shape, place, nearest.ray_.direction);
            return std::optional<Hit>(std::in_place, t, place, geometric_normal, geometric_normal,
                                      material);
        }
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    const Watch* watch_;
    Interval interval_;
    [[no_unique_address]] ClosestPrimitive leader_;
    std::optional<MeshHit> in_mesh_;  ///< set if the closest hit is on a mesh
    const void* winner_ = nullptr;
    std::optional<Hit> (*describe_)(const ClosestHit&) = nullptr;
};

/// Returns whether the ray hits the shape anywhere strictly inside the interval. For a mesh this is
/// faster than the closest hit.
template <class Shape>
bool occludes(const Ray& ray, const Shape& shape, Interval interval) {
    return intersect(ray, shape, interval).has_value();
}

/// The any-hit query of a ray: tests lists of shapes for any hit inside the interval, and stops at
/// the first one found. The ray must outlive the query.
class AnyHit {
public:
    AnyHit(const Ray& ray, Interval interval, Context& context)
        : ray_(ray),
          slabs_(ray),
          interval_(interval),
          watched_(context.watch == nullptr ? nullptr : &context) {
        ++context.rays;
    }

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (!primitives.empty() && !found_) test_list(primitives);
    }

    /// Tests only the primitives of a short list whose bit in `chosen` is set.
    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives, std::uint64_t chosen) {
        if (!primitives.is_short_list()) return test(primitives);
        if (watched_ != nullptr) [[unlikely]]
            return test_watched(primitives, chosen);
        while (chosen != 0 && !found_)
            if (occludes(ray_, primitives[pop_lowest_bit(chosen)].shape, interval_)) found_ = true;
    }

    [[nodiscard]] bool found() const { return found_; }

private:
    /// Defined in queries.hpp.
    template <class Shape>
    void test_list(const PrimitiveList<Shape>& primitives);

    template <class Shape, class... Chosen>
    [[gnu::noinline]] void test_watched(const PrimitiveList<Shape>& primitives, Chosen... chosen) {
        const Context* const context = std::exchange(watched_, nullptr);
        watch_any(*context, ray_, interval_, primitives, chosen...);
        test(primitives, chosen...);
        watched_ = context;
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    Interval interval_;
    const Context* watched_;  ///< if a watcher looks at the query
    bool found_ = false;
};

}  // namespace RT_PRECISION
}  // namespace rt
