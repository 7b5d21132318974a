// The tests of a query on a list of shapes, and their observation (watch.hpp). The file queries.cpp
// of each kind of shape compiles them, once for all programs.
#pragma once

#include "common/bvh/mesh_bvh.hpp"
#include "common/explain/pixel_log.hpp"
#include "common/explain/ray_records.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/shaft.hpp"
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
/// of shape defines logged_intersect by it, as which stage.cmake compiles the loop's `intersect`.
template <class Shape>
[[nodiscard]] std::optional<Real> logged(const Ray& ray, const Shape& shape, Interval interval) {
    const std::optional<Real> t = intersect(ray, shape, interval);
    if (log_of_own_loop != nullptr) log_candidate(*log_of_own_loop, ray, shape, interval, t);
    return t;
}

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

inline namespace RT_PRECISION {

// Not inlined in `test`, so that an empty list costs one branch. In the unity build of a kind of
// shape (common/cmake/stage.cmake) everything is inlined here, `intersect` included.

template <class Shape>
[[gnu::noinline, gnu::flatten]] void ClosestHit::test_list(const PrimitiveList<Shape>& primitives) {
    if (watch_ != nullptr) [[unlikely]]
        return test_watched(primitives);
    primitives.traverse(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
        keep(primitive, intersect(ray_, primitive.shape, interval_));
    });
}

template <class Shape>
[[gnu::noinline, gnu::flatten]] void AnyHit::test_list(const PrimitiveList<Shape>& primitives) {
    if (watched_ != nullptr) [[unlikely]]
        return test_watched(primitives);
    if (primitives.traverse_any(slabs_, interval_, [this](const Primitive<Shape>& primitive) {
            return occludes(ray_, primitive.shape, interval_);
        }))
        found_ = true;
}

template <class Shape>
void PotentialOccluders::collect(const PrimitiveList<Shape>& primitives) {
    std::uint64_t chosen = 0;
    if (primitives.is_short_list()) {
        // The test of the bounding sphere is faster, and usually decides.
        const BoundingSphereSet& balls = primitives.balls();
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const bool held = (balls.empty() || shaft_.may_intersect(balls[i])) &&
                              shaft_.may_intersect(primitives[i].shape);
            chosen |= std::uint64_t(held) << i;
        }
    } else {
        chosen = !primitives.has_bvh() || shaft_.may_intersect(primitives.box()) ? 1 : 0;
    }
    if (chosen != 0)
        kinds_[count_++] = {.primitives = &primitives, .chosen = chosen, .ask = &ask<Shape>};
}

}  // namespace RT_PRECISION
}  // namespace rt
