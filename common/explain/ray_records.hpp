// The rays of one pixel as numbers, for --shade and for --rays.
#pragma once

#include "common/geometry/ray.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rt {

/// The purpose of a ray.
enum class RayKind { eye, mirrored, shadow };

/// A vector in any precision.
using Numbers = std::array<double, 3>;

/// One ray, and what it hits.
struct RayRecord {
    RayKind kind = RayKind::eye;
    std::int64_t number = 0;  ///< of the ray among all that are traced, from 1
    int bounces = 0;  ///< reflections off mirrors before this ray, or before the point it leaves
    Numbers origin{};
    Numbers direction{};
    double end = 0;                  ///< t at the light, for a shadow ray; otherwise infinite
    std::optional<double> t{};       ///< of the closest hit, or of an occluder
    const void* shape = nullptr;     ///< the Primitive that is hit
    std::optional<Numbers> point{};  ///< of the closest hit
    Numbers normal{};                ///< there, outward
    std::int64_t tests = 0;          ///< number of shapes, and of boxes and triangles inside meshes
};

/// The rays of one pixel, in the order in which they are traced.
struct RayRecords {
    std::vector<RayRecord> rays;
};

[[nodiscard]] inline Numbers numbers(const Vec3& v) {
    return {double(v.x), double(v.y), double(v.z)};
}

/// Starts the record of a ray.
inline void begin(RayRecords& records, RayKind kind, std::int64_t number, int bounces,
                  const Ray& ray, Real end) {
    records.rays.push_back({.kind = kind,
                            .number = number,
                            .bounces = bounces,
                            .origin = numbers(ray.origin),
                            .direction = numbers(ray.direction),
                            .end = double(end)});
}

/// The last record of a closest-hit query of this ray.
[[nodiscard]] inline RayRecord& closest_record(RayRecords& records, const Ray& ray) {
    const Numbers direction = numbers(ray.direction);
    for (std::size_t i = records.rays.size(); i-- > 1;)
        if (records.rays[i].kind != RayKind::shadow && records.rays[i].direction == direction)
            return records.rays[i];
    return records.rays.front();
}

}  // namespace rt
