// The workload of the engines: meshes and rays, the same for all, in float.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace measurements {

using Point = std::array<float, 3>;

struct TriangleMesh {
    std::vector<Point> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The sphere of 20 · frequency² triangles, closed, moved in and out by up to a tenth.
[[nodiscard]] TriangleMesh displaced_sphere(int frequency);

struct RayQuery {
    Point origin;
    Point direction;
    float max;
};

/// Rays of one kind. Shadow rays test for any hit, the others for the closest.
struct RaySet {
    std::string name;
    bool shadow = false;
    std::vector<RayQuery> rays;
};

struct NearestHit {
    static constexpr std::uint32_t none = ~std::uint32_t(0);

    float t = 0;
    std::uint32_t triangle = none;
};

/// One implementation of ray tracing.
class Engine {
public:
    virtual ~Engine() = default;
    virtual void build(const TriangleMesh& mesh) = 0;
    [[nodiscard]] virtual NearestHit nearest(const RayQuery& ray) const = 0;
    /// The number of rays that hit anything; all in one call, so that the call's overhead is
    /// negligible.
    [[nodiscard]] virtual std::size_t count_nearest(const RayQuery* rays, std::size_t n) const = 0;
    [[nodiscard]] virtual std::size_t count_blocked(const RayQuery* rays, std::size_t n) const = 0;
};

/// Primary rays of a picture, diffuse rays from their hits, random rays through the mesh, and
/// shadow rays to a light. `engine` must have built the mesh.
[[nodiscard]] std::vector<RaySet> ray_sets(const TriangleMesh& mesh, const Engine& engine);

/// From inside, at every vertex and at two points of every edge: each must hit.
[[nodiscard]] std::vector<RayQuery> rays_at_edges(const TriangleMesh& mesh);

// The engines that are compared.

/// Raysteps in both precisions.
[[nodiscard]] std::unique_ptr<Engine> float_engine();
[[nodiscard]] std::unique_ptr<Engine> double_engine();

/// Embree 3, one ray at a time, with its defaults; null if CMake did not find it.
[[nodiscard]] std::unique_ptr<Engine> embree_engine();

}  // namespace measurements
