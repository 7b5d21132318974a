// The closest hit of a ray among all shapes (M1, "plusieurs objets"; CR §2.1), and the any-hit
// query (CR §3.2).
#pragma once

#include "common/explain/pixel_log.hpp"
#include "common/explain/ray_records.hpp"
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

/// The number of tests that a query of a shape takes: one, but of a mesh many.
template <class Shape>
std::int64_t test_count(const Ray& /*ray*/, const Shape& /*shape*/, Interval /*interval*/,
                        QueryKind /*query*/) {
    return 1;
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
            begin_record(context.bounces);
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
            watch_hit(*hit);
        return hit;
    }

private:
    [[gnu::noinline]] void begin_record(int bounces) const {
        if (RayRecords* const records = watch_->records)
            begin(*records, bounces == 0 ? RayKind::eye : RayKind::mirrored, bounces, ray_,
                  infinity);
    }

    template <class Shape>
    void test_list(const PrimitiveList<Shape>& primitives);

    template <class Shape>
    [[gnu::noinline]] void watch_list(const PrimitiveList<Shape>& primitives) {
        if (watch_->log != nullptr)
            log_list(primitives, *watch_->log);
        else
            record_list(primitives, *watch_->records);
    }

    /// Logs the misses too, which a hierarchy would skip.
    template <class Shape>
    void log_list(const PrimitiveList<Shape>& primitives, PixelLog& log) {
        for (const Primitive<Shape>& primitive : primitives) {
            const auto answer = intersect(ray_, primitive.shape, interval_);
            explain_candidate(log, ray_, primitive.shape, interval_, t_of(answer));
            keep(primitive, answer);
        }
    }

    /// As test_list, and records the tests and the closest shape.
    template <class Shape>
    void record_list(const PrimitiveList<Shape>& primitives, RayRecords& records) {
        RayRecord& record = closest_record(records, ray_);
        primitives.traverse(slabs_, interval_, [&](const Primitive<Shape>& primitive) {
            record.tests += test_count(ray_, primitive.shape, interval_, QueryKind::closest_hit);
            keep(primitive, intersect(ray_, primitive.shape, interval_));
            if (winner_ == &primitive) record.shape = &primitive;
        });
    }

    [[gnu::noinline]] void watch_hit(const Hit& hit) const {
        if (watch_->log != nullptr) return explain_hit(*watch_->log, hit.point, hit.normal);
        RayRecord& record = closest_record(*watch_->records, ray_);
        record.t = double(hit.t);
        record.point = numbers(hit.point);
        record.normal = numbers(hit.normal);
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
            const Vec3 geometric_normal = normal_at(shape, place, nearest.ray_.direction);
            return std::optional<Hit>(std::in_place, t, place, geometric_normal, geometric_normal,
                                      material);
        }
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    const Watch* watch_;
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
        : ray_(ray),
          slabs_(ray),
          interval_(interval),
          context_(context),
          state_(context.watch == nullptr ? open : watched) {
        ++context.rays;
    }

    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives) {
        if (!primitives.empty() && !found()) test_list(primitives);
    }

    /// Tests only the primitives of a short list whose bit in `chosen` is set.
    template <class Shape>
    void test(const PrimitiveList<Shape>& primitives, std::uint64_t chosen) {
        if (!primitives.is_short_list()) return test(primitives);
        if (state_ == watched) [[unlikely]]
            return watch_some(primitives, chosen);
        while (chosen != 0 && state_ == open) {
            const Primitive<Shape>& primitive = primitives[pop_lowest_bit(chosen)];
            state_ = occludes(ray_, primitive.shape, interval_) ? hit : open;
        }
    }

    [[nodiscard]] bool found() const { return state_ >= hit; }

private:
    // The states of a query. A single comparison shows that it goes on, or that it is not watched.
    static constexpr std::uint8_t open = 0;
    static constexpr std::uint8_t watched = 1;
    static constexpr std::uint8_t hit = 2;
    static constexpr std::uint8_t watched_hit = 3;

    template <class Shape>
    void test_list(const PrimitiveList<Shape>& primitives);

    template <class Shape>
    [[gnu::noinline]] void watch_list(const PrimitiveList<Shape>& primitives) {
        begin_record();
        if (primitives.traverse_any(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
                return watched_test(primitive);
            }))
            state_ = watched_hit;
    }

    template <class Shape>
    [[gnu::noinline]] void watch_some(const PrimitiveList<Shape>& primitives,
                                      std::uint64_t chosen) {
        begin_record();
        while (chosen != 0 && state_ == watched)
            if (watched_test(primitives[pop_lowest_bit(chosen)])) state_ = watched_hit;
    }

    /// Starts the record of the ray with its first test.
    void begin_record() {
        RayRecords* const records = context_.watch->records;
        if (records != nullptr && !is_recorded_)
            begin(*records, RayKind::shadow, context_.bounces, ray_, interval_.max);
        is_recorded_ = true;
    }

    template <class Shape>
    [[nodiscard]] bool watched_test(const Primitive<Shape>& primitive) {
        const auto& [log, records] = *context_.watch;
        const Shape& shape = primitive.shape;
        const bool in_the_way = occludes(ray_, shape, interval_);
        if (log != nullptr && in_the_way) log->remark("in the way: " + code(shape));
        if (records == nullptr) return in_the_way;
        RayRecord& record = records->rays.back();
        record.tests += test_count(ray_, shape, interval_, QueryKind::any_hit);
        if (!in_the_way) return false;
        record.shape = &primitive;
        if (const auto t = t_of(intersect(ray_, shape, interval_))) record.t = double(*t);
        return true;
    }

    const Ray& ray_;
    RayBoxTestCache slabs_;
    Interval interval_;
    const Context& context_;
    std::uint8_t state_;
    bool is_recorded_ = false;
};

// Not inlined in `test`, so that an empty list costs one branch. In the unity build of a kind of
// shape (common/cmake/stage.cmake) everything is inlined here, `intersect` included.

template <class Shape>
[[gnu::noinline, gnu::flatten]] void ClosestHit::test_list(const PrimitiveList<Shape>& primitives) {
    if (watch_ != nullptr) [[unlikely]]
        return watch_list(primitives);
    primitives.traverse(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
        keep(primitive, intersect(ray_, primitive.shape, interval_));
    });
}

template <class Shape>
[[gnu::noinline, gnu::flatten]] void AnyHit::test_list(const PrimitiveList<Shape>& primitives) {
    if (state_ == watched) [[unlikely]]
        return watch_list(primitives);
    if (primitives.traverse_any(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
            return occludes(ray_, primitive.shape, interval_);
        }))
        state_ = hit;
}

// Both are compiled once for each kind of shape, in the file queries.cpp of its stage, and not in
// each file with a query.
extern template void ClosestHit::test_list(const PrimitiveList<Sphere>&);
extern template void ClosestHit::test_list(const PrimitiveList<Plane>&);
extern template void ClosestHit::test_list(const PrimitiveList<Triangle>&);
extern template void ClosestHit::test_list(const PrimitiveList<Square>&);
extern template void ClosestHit::test_list(const PrimitiveList<Cylinder>&);
extern template void ClosestHit::test_list(const PrimitiveList<Cone>&);
extern template void ClosestHit::test_list(const PrimitiveList<OrientedBox>&);
extern template void ClosestHit::test_list(const PrimitiveList<MeshInstance>&);
extern template void AnyHit::test_list(const PrimitiveList<Sphere>&);
extern template void AnyHit::test_list(const PrimitiveList<Plane>&);
extern template void AnyHit::test_list(const PrimitiveList<Triangle>&);
extern template void AnyHit::test_list(const PrimitiveList<Square>&);
extern template void AnyHit::test_list(const PrimitiveList<Cylinder>&);
extern template void AnyHit::test_list(const PrimitiveList<Cone>&);
extern template void AnyHit::test_list(const PrimitiveList<OrientedBox>&);
extern template void AnyHit::test_list(const PrimitiveList<MeshInstance>&);

}  // namespace RT_PRECISION
}  // namespace rt
