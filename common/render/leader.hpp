// The closest primitive so far along a ray: by its rounded t, or with `--precision exact` by exact
// arithmetic.
#pragma once

#ifdef RT_EXACT

#include "common/exact/leader.hpp"

#else

#include "common/geometry/mesh.hpp"
#include "common/scene/primitives.hpp"

#include <optional>

namespace rt {
inline namespace RT_PRECISION {

/// By rounded t. Every hit ends the interval of the query, so that the last hit is the closest one.
class ClosestPrimitive {
public:
    /// The t of the closest hit, where the interval of the query ends.
    [[nodiscard]] static Real t(const Interval& interval) { return interval.max; }

    /// Considers a hit inside the interval, and returns whether it is the closest one.
    template <class Shape>
    static bool accepts(const Ray& /*ray*/, const Primitive<Shape>& /*primitive*/, Real t,
                        Interval& interval) {
        interval.max = t;
        return true;
    }
    template <class Shape>
    static bool accepts(const Ray& ray, const Primitive<Shape>& primitive, const MeshHit& hit,
                        Interval& interval) {
        return accepts(ray, primitive, hit.t, interval);
    }
};

}  // namespace RT_PRECISION
}  // namespace rt

#endif
