#include "common/tuning/input_rounding.hpp"

#include "common/render/sampling.hpp"
#include "common/scene/surface_points.hpp"
#include "common/tuning/wording.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace rt {

namespace {

constexpr std::size_t surface_samples = 64;  ///< sample points on a surface
constexpr std::size_t twentieth = surface_samples / 20;

/// Limits on the number of tested pairs of shapes, so that no scene takes long: a second for
/// testing boxes, or for testing surfaces.
constexpr std::size_t most_looks = 100'000'000;
constexpr std::size_t looks_for_a_pair = 10'000;

/// A shape of any kind.
struct Surface {
    BoundingBox box;
    std::function<Vec3(Vec2)> point;  ///< maps a point of the unit square to the surface
    std::function<Real(Vec3)> distance;
};

/// The size of a plane's coordinates: the distance of the plane from the origin, taken
/// componentwise. Coordinates along the plane do not matter.
Real largest_coordinate(const Plane& plane) {
    return dot(abs(plane.normal), abs(plane.point)) / length(plane.normal);
}

template <class Shape>
Real largest_coordinate(const Shape& shape) {
    return largest_component(bounds(shape));
}

void take_in(SceneLengths& scene, const auto& primitives) {
    for (const auto& primitive : primitives) {
        const auto& shape = primitive.shape;  // clang++ 14 tests no structured binding by requires
        scene.largest = std::max(scene.largest, double(largest_coordinate(shape)));
        if constexpr (requires { smallest_size(shape); })
            if (const double feature = smallest_size(shape); feature > 0)
                scene.smallest = scene.smallest == 0 ? feature : std::min(scene.smallest, feature);
    }
}

/// The largest distance from `surface`'s nearest twentieth to the other surface.
Real gap(const Surface& surface, const std::function<Real(Vec3)>& distance) {
    std::array<Real, surface_samples> distances;
    for (std::size_t i = 0; i < surface_samples; ++i)
        distances[i] = distance(surface.point(spread_sample(std::uint32_t(i), 0)));
    std::nth_element(distances.begin(), distances.begin() + twentieth, distances.end());
    return distances[twentieth];
}

bool apart(const BoundingBox& a, const BoundingBox& b, Real distance) {
    const Vec3 way = glm::max(a.min - b.max, b.min - a.max);
    return glm::max(way.x, glm::max(way.y, way.z)) > distance;
}

std::vector<Surface> bounded_surfaces(const Scene& scene) {
    std::vector<Surface> surfaces;
    const auto take = [&surfaces](const auto& primitives) {
        for (const auto& primitive : primitives) {
            const auto& shape = primitive.shape;
            if constexpr (requires { bounds(shape); })
                surfaces.push_back(
                    {.box = bounds(shape),
                     .point = [&shape](Vec2 place) { return surface_point(shape, place); },
                     .distance =
                         [&shape](Vec3 point) { return distance_to_surface(point, shape); }});
        }
    };
    for_each_kind(scene, take);
    take(scene.meshes);
    std::ranges::sort(surfaces, {}, [](const Surface& surface) { return surface.box.min.x; });
    return surfaces;
}

/// The smallest gap between two shapes of the scene, if it is below `widest`; else infinity.
Real smallest_gap(const Scene& scene, Real widest) {
    Real least = infinity;
    const auto consider = [&](Real gap) {
        if (gap < widest) least = glm::min(least, gap);
    };
    const std::vector<Surface> surfaces = bounded_surfaces(scene);
    std::size_t looks = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const Surface& a = surfaces[i];
        for (const auto& plane : scene.planes) {
            const auto to_plane = [&](Vec3 point) {
                return distance_to_surface(point, plane.shape);
            };
            const Real middle = to_plane(a.box.min / Real(2) + a.box.max / Real(2));
            if (!(middle - length(a.box.max - a.box.min) < widest)) continue;
            consider(gap(a, to_plane));
            looks += looks_for_a_pair;
        }
        for (std::size_t k = i + 1; k < surfaces.size() && looks < most_looks; ++k, ++looks) {
            const Surface& b = surfaces[k];
            if (b.box.min.x > a.box.max.x + widest) break;
            if (apart(a.box, b.box, widest)) continue;
            consider(gap(a, b.distance));
            consider(gap(b, a.distance));
            looks += looks_for_a_pair;
        }
    }
    for (std::size_t i = 0; i < scene.planes.size(); ++i)
        for (std::size_t k = i + 1; k < scene.planes.size() && looks < most_looks; ++k, ++looks)
            consider(distance(scene.planes[i].shape, scene.planes[k].shape));
    return least;
}

}  // namespace

SceneLengths RT_PRECISION::scene_sizes(const Scene& scene) {
    SceneLengths found;
    found.largest = double(largest_component(scene.cameras.front().position));
    for_each_kind(scene, [&](const auto& primitives) { take_in(found, primitives); });
    take_in(found, scene.meshes);
    for (const MeshRequest& mesh : scene.mesh_requests)
        found.largest =
            std::max(found.largest, double(largest_component(mesh.placement.translation)));
    return found;
}

SceneLengths RT_PRECISION::scene_lengths(const Scene& scene) {
    SceneLengths found = scene_sizes(scene);
    const double widest = SceneLengths::widest_lost_gap * found.displacement(float_unit_roundoff);
    const auto gap = double(smallest_gap(scene, Real(widest)));
    found.gap = gap > 16 * double(unit_roundoff) * found.largest ? gap : 0;
    return found;
}

#ifndef RT_FLOAT

namespace {

/// The rounding error of a precision, and the lengths whose squares are within its range.
struct PrecisionLimits {
    std::string name;
    double roundoff;
    /// The longest and the shortest length that are computed with safely: with distances in
    /// between, squares and products of lengths reach the limits of the range, 3e38 and 1e-38 or
    /// 2e308 and 2e-308.
    double longest;
    double shortest;
};

std::vector<std::string> risks(const SceneLengths& scene, const PrecisionLimits& precision) {
    const std::string off = "coordinates reach " + number(scene.largest) +
                            ", so that surfaces in " + precision.name + " are off by up to " +
                            number(scene.displacement(precision.roundoff));
    std::vector<std::string> found;
    if (scene.loses_sizes(precision.roundoff))
        found.push_back(off + ", and the smallest shape has a size of " + number(scene.smallest));
    if (scene.loses_gaps(precision.roundoff))
        found.push_back(off + ", and two of them are only " + number(scene.gap) + " apart");
    const std::string out = ", whose square is out of the range of " + precision.name;
    if (scene.largest > precision.longest)
        found.push_back("coordinates reach " + number(scene.largest) + out);
    if (scene.smallest > 0 && scene.smallest < precision.shortest)
        found.push_back("the smallest shape has a size of " + number(scene.smallest) + out);
    return found;
}

}  // namespace

std::vector<std::string> f64::risks_in_float(const SceneLengths& scene) {
    return risks(
        scene,
        {.name = "float", .roundoff = float_unit_roundoff, .longest = 1e18, .shortest = 1e-18});
}

std::vector<std::string> f64::risks_in_double(const SceneLengths& scene) {
    return risks(
        scene, {.name = "double", .roundoff = unit_roundoff, .longest = 1e153, .shortest = 1e-153});
}

#endif

}  // namespace rt
