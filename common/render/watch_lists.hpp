// The observation of a query's lists (watch.hpp), defined for the files queries.cpp of the stages.
#pragma once

#include "common/bvh/mesh_bvh.hpp"
#include "common/explain/pixel_log.hpp"
#include "common/explain/ray_records.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/watch.hpp"
#include "common/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace rt {
inline namespace RT_PRECISION {

/// The t of a result of `intersect`, which is a t or a MeshHit.
inline std::optional<Real> t_of(std::optional<Real> answer) {
    return answer;
}
inline std::optional<Real> t_of(const std::optional<MeshHit>& answer) {
    if (!answer) return std::nullopt;
    return answer->t;
}

}  // namespace RT_PRECISION
}  // namespace rt

namespace rt {

/// The number of tests that a query of a shape takes: one, but of a mesh many.
template <class Shape>
std::int64_t test_count(const Ray& /*ray*/, const Shape& /*shape*/, Interval /*interval*/,
                        QueryKind /*query*/) {
    return 1;
}

template <class Shape>
void log_candidate(PixelLog& log, const Ray& ray, const Shape& shape, Interval interval,
                   std::optional<Real> t) {
    explain_candidate(log, ray, shape, interval, t, [&] {
        return t_of(intersect(ray, shape, {.min = interval.min, .max = infinity}));
    });
}

/// The answer of `intersect`, logged, for a student's own loop. The file queries.cpp of each kind
/// of shape defines a function of this, in place of which the loop calls `intersect` otherwise.
template <class Shape>
[[nodiscard]] std::optional<Real> logged(const Ray& ray, const Shape& shape, Interval interval) {
    const std::optional<Real> t = intersect(ray, shape, interval);
    if (log_of_own_loop != nullptr) log_candidate(*log_of_own_loop, ray, shape, interval, t);
    return t;
}

// These, with the name that stage.cmake gives to `intersect` for it.
std::optional<Real> logged_intersect(const Ray& ray, const Sphere& sphere, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Plane& plane, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Triangle& triangle, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Square& square, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Cylinder& cylinder, Interval interval);
std::optional<Real> logged_intersect(const Ray& ray, const Cone& cone, Interval interval);

/// The log contains the misses too, which a hierarchy would skip.
template <class Shape>
[[gnu::noinline]] void watch_closest(const Watch& watch, const Ray& ray, Interval interval,
                                     ClosestPrimitive leader,
                                     const PrimitiveList<Shape>& primitives) {
    const auto test = [&](const Primitive<Shape>& primitive) {
        const auto answer = intersect(ray, primitive.shape, interval);
        if (watch.log != nullptr)
            log_candidate(*watch.log, ray, primitive.shape, interval, t_of(answer));
        else
            closest_record(*watch.records, ray).tests +=
                test_count(ray, primitive.shape, interval, QueryKind::closest_hit);
        if (answer) static_cast<void>(leader.accepts(ray, primitive, *answer, interval));
    };
    if (watch.log != nullptr) {
        for (const Primitive<Shape>& primitive : primitives) test(primitive);
    } else {
        RayBoxTestCache slabs(ray);
        primitives.traverse(slabs, interval, test);
    }
}

/// Logs or records the test of an any-hit query on one primitive, and returns its result.
template <class Shape>
[[nodiscard]] bool watched_test(const Context& context, const Ray& ray, Interval interval,
                                const Primitive<Shape>& primitive) {
    const auto& [log, records] = *context.watch;
    const Shape& shape = primitive.shape;
    const bool occluded = occludes(ray, shape, interval);
    if (occluded && log != nullptr &&
        log->shadow_test(context.rays) != PixelLog::ShadowTest::left_out) {
        const auto t = t_of(intersect(ray, shape, interval));
        log->remark("in the way at t = " + (t ? text(*t) : "?") + ": " +
                    (&primitive == log->surface ? "this surface itself, " : "") + code(shape));
    }
    if (records == nullptr) return occluded;
    RayRecord& record = records->rays.back();
    record.tests += test_count(ray, shape, interval, QueryKind::any_hit);
    if (!occluded) return false;
    record.shape = &primitive;
    if (const auto t = t_of(intersect(ray, shape, interval))) record.t = double(*t);
    return true;
}

template <class Shape>
[[gnu::noinline]] void watch_any(const Context& context, const Ray& ray, Interval interval,
                                 const PrimitiveList<Shape>& primitives) {
    begin_shadow_ray(context, ray, interval);
    RayBoxTestCache slabs(ray);
    static_cast<void>(
        primitives.traverse_any(slabs, interval, [&](const Primitive<Shape>& primitive) {
            return watched_test(context, ray, interval, primitive);
        }));
}

template <class Shape>
[[gnu::noinline]] void watch_any(const Context& context, const Ray& ray, Interval interval,
                                 const PrimitiveList<Shape>& primitives, std::uint64_t chosen) {
    begin_shadow_ray(context, ray, interval);
    while (chosen != 0)
        if (watched_test(context, ray, interval, primitives[pop_lowest_bit(chosen)])) return;
}

}  // namespace rt
