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
class ClosestHit {
public:
    ClosestHit(const Ray& ray, Context& context) : ray_(ray), slabs_(ray), log_(context.log) {
        ++context.rays;
    }

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        // The rest is not inlined here, so that an empty list costs one branch. Inside that
        // function everything is inlined, `intersect` included, in a unity build
        // (common/cmake/stage.cmake).
        if (primitives.empty()) return;
        if (log_ == nullptr)
            test_list(primitives);
        else
            log_list(primitives);
    }

    /// The closest hit in the lists tested so far, or nothing.
    [[nodiscard]] std::optional<Hit> hit() const {
        if (winner_ == nullptr) return std::nullopt;
        const std::optional<Hit> hit = describe_(*this);
        if (log_ != nullptr) explain_hit(*log_, hit->point, hit->normal);
        return hit;
    }

private:
    template <class Shape>
    [[gnu::noinline, gnu::flatten]] void test_list(const PrimitiveList<Shape>& primitives) {
        primitives.traverse(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
            keep(primitive, intersect(ray_, primitive.shape, interval_));
        });
    }

    /// Logs the misses too, which a hierarchy would skip.
    template <class Shape>
    [[gnu::noinline]] void log_list(const PrimitiveList<Shape>& primitives) {
        for (const Primitive<Shape>& primitive : primitives) {
            const auto answer = intersect(ray_, primitive.shape, interval_);
            explain_candidate(*log_, ray_, primitive.shape, interval_, t_of(answer));
            keep(primitive, answer);
        }
    }

    template <class Shape, class Answer>
    void keep(const Primitive<Shape>& primitive, const Answer& answer) {
        if (!answer) return;
#ifdef RT_EXACT
        if (!leader_.accepts(ray_, primitive, *answer, interval_)) return;
#else
        interval_.max = *t_of(answer);
#endif
        if constexpr (std::is_same_v<Shape, MeshInstance>) in_mesh_ = *answer;
        winner_ = &primitive;
        describe_ = &describe<Shape>;
    }

#ifdef RT_EXACT
    [[nodiscard]] Real t() const {
        return leader_.t();
    }
    ClosestPrimitive leader_;
#else
    [[nodiscard]] Real t() const {
        return interval_.max;
    }
#endif

    template <class Shape>
    [[gnu::flatten]] static std::optional<Hit> describe(const ClosestHit& nearest) {
        const auto& [shape, material] = *static_cast<const Primitive<Shape>*>(nearest.winner_);
        const Real t = nearest.t();
        // Constructed in place, so that nothing is copied.
        if constexpr (std::is_same_v<Shape, MeshInstance>) {
            const MeshHit& hit = *nearest.in_mesh_;
            return std::optional<Hit>(std::in_place, t, snapped_to(shape, hit), normal(shape, hit),
                                      geometric_normal(shape, hit), material);
        } else {
            const PointWithError place = snapped_to(shape, at(nearest.ray_, t));
            const Vec3 geometric_normal = normal(shape, place.point);
            return std::optional<Hit>(std::in_place, t, place, geometric_normal, geometric_normal,
                                      material);
        }
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    PixelLog* log_;
    Interval interval_;
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
        : ray_(ray), slabs_(ray), interval_(interval), log_(context.log) {
        ++context.rays;
    }

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (!primitives.empty() && !found_) found_ = test_list(primitives);
    }

    /// Tests only the primitives of a short list whose bit in `chosen` is set.
    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives, std::uint64_t chosen) {
        if (!primitives.is_short_list()) return test(primitives);
        while (chosen != 0 && !found_) found_ = is_in_the_way(primitives[pop_lowest_bit(chosen)]);
    }

    [[nodiscard]] bool found() const { return found_; }

private:
    template <class Shape>
    [[nodiscard, gnu::noinline, gnu::flatten]] bool test_list(
        const PrimitiveList<Shape>& primitives) {
        return primitives.traverse_any(
            slabs_, interval_,
            [this](const Primitive<Shape>& primitive) { return is_in_the_way(primitive); });
    }

    template <class Shape>
    [[nodiscard]] bool is_in_the_way(const Primitive<Shape>& primitive) {
        const bool in_the_way = occludes(ray_, primitive.shape, interval_);
        if (in_the_way && log_ != nullptr) explain(primitive.shape);
        return in_the_way;
    }

    template <class Shape>
    [[gnu::noinline]] void explain(const Shape& shape) {
        log_->remark("in the way: " + code(shape));
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    Interval interval_;
    PixelLog* log_;
    bool found_ = false;
};

}  // namespace RT_PRECISION
}  // namespace rt
