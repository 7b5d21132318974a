// The observation of queries from outside, for --pixel, --shade and --rays. The functions look at a
// query's list of shapes before it does, and test it themselves; the query is not changed by it.
#pragma once

#include "common/geometry/ray.hpp"
#include "common/render/context.hpp"
#include "common/render/leader.hpp"
#include "common/scene/primitives.hpp"

#include <cstdint>

namespace rt {

// Called where a closest-hit query begins, and where its hit is known.
void watch_ray(const Context& context, const Ray& ray);
void watch_hit(const Watch& watch, const Ray& ray, const void* primitive, Real t, Vec3 point,
               Vec3 normal);

/// Logs or records the tests of a closest-hit query on a list, from the query's state before it.
template <class Shape>
void watch_closest(const Watch& watch, const Ray& ray, Interval interval, ClosestPrimitive leader,
                   const PrimitiveList<Shape>& primitives);

/// Logs a shadow ray, the context's last ray, or starts its record, unless that is done.
void begin_shadow_ray(const Context& context, const Ray& ray, Interval interval);

// Log or record the tests of an any-hit query, that of the context's last ray, on a list, or on
// those primitives of a short list whose bit is set.
template <class Shape>
void watch_any(const Context& context, const Ray& ray, Interval interval,
               const PrimitiveList<Shape>& primitives);
template <class Shape>
void watch_any(const Context& context, const Ray& ray, Interval interval,
               const PrimitiveList<Shape>& primitives, std::uint64_t chosen);

}  // namespace rt
