// The certified triangle, for the meshes of `--precision exact`.
#pragma once

#include "common/triangle_packet.hpp"
#include "common/vector.hpp"

#include "steps/step05_triangle/triangle.hpp"

namespace rt::inline RT_PRECISION {

inline namespace RT_LANES {

/// TriangleTest with stage 5's certified kernel, one triangle after the other.
class ExactTriangleTest {
public:
    explicit ExactTriangleTest(const Ray& ray) : ray_(ray) {}

    [[nodiscard]] Crossings operator()(const TrianglePacket& packet, Interval interval) const {
        std::array<std::array<Real, lane_count>, 3> areas{};
        std::array<Real, lane_count> times{};
        unsigned hits = 0;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const Triangle triangle = triangle_in(packet, lane);
            if (std::isnan(triangle.a.x)) break;  // a lane not used
            const auto t = intersect(ray_, triangle, interval);
            if (!t) continue;
            hits |= 1U << lane;
            times[lane] = *t;
            const Vec3 weights = barycentric(triangle, at(ray_, *t));
            for (std::size_t i = 0; i < 3; ++i) areas[i][lane] = weights[glm::length_t(i)];
        }
        return {.areas = std::bit_cast<std::array<Lanes, 3>>(areas),
                .t = std::bit_cast<Lanes>(times),
                .hits = hits};
    }

private:
    static Triangle triangle_in(const TrianglePacket& packet, std::size_t lane) {
        const auto corner = [&](std::size_t vertex) {
            const auto& [x, y, z] = packet.vertices[vertex];
            return Vec3(values(x)[lane], values(y)[lane], values(z)[lane]);
        };
        return {.a = corner(0), .b = corner(1), .c = corner(2)};
    }

    Ray ray_;
};

}  // namespace RT_LANES

}  // namespace rt::inline RT_PRECISION
