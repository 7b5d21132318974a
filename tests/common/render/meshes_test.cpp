// A mesh in a scene: the cost that --shade cost shows, and its normals.
#include "common/math/simd.hpp"

#include "common/math/vector.hpp"
#include "common/render/pixel_values.hpp"

#include "steps/step13_meshes/mesh_instance.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/meshes.hpp"

#include <cmath>
#include <memory>
#include <utility>

using namespace rt;

namespace {

/// A mesh in the scene of its coordinates, packed if that pays.
Primitive<MeshInstance> placed(Mesh mesh) {
    return {.shape = {.model = mesh_geometry(std::move(mesh))}, .material = {}};
}

constexpr int packet = int(real_count);  ///< the number of triangles that are tested at once

/// As many triangles, one behind the other, at each of so many places, the first in the middle.
Mesh packets(int count) {
    Mesh mesh;
    for (int i = 0; i < packet * count; ++i) {
        const auto x = Real(3 * (i / packet));
        const auto z = Real(-5 - i % packet);
        const auto first = std::uint32_t(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {{x - 1, -1, z}, {x + 1, -1, z}, {x, 1, z}});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// The cost in the middle of a picture of 3 × 3 pixels, or in its corner at the upper left. The
/// picture is seen from the origin, along −z.
float cost(const Scene& scene, bool in_corner) {
    const auto values = pixel_values(scene, {.settings = {.shading = Shading::cost}});
    return values->numbers[in_corner ? 0 : 4].value();
}

}  // namespace

TEST_CASE("cost counts the boxes and triangles inside a mesh") {
    Scene scene{.resolution = {.width = 3, .height = 3}, .cameras = {Camera{}}};
    scene.cameras.front().fov = 2 * std::atan(Real(1));
    scene.meshes = {placed(packets(8))};
    // One node, with a box for each of the eight leaves, and the leaf of those in the middle.
    CHECK(cost(scene, false) == 8 + packet);
    CHECK(cost(scene, true) == 8);
    // A mesh of few triangles has one box.
    scene.meshes = {placed(packets(1))};
    CHECK(cost(scene, false) == 1 + packet);
    CHECK(cost(scene, true) == 1);
}

// Normals of a mesh in a scene whose axes are left-handed.

TEST_CASE("both normals of a ball are outward, also in left-handed axes") {
    Mesh mesh = refined(octahedron());
    mesh.normals = mesh.vertices;
    const auto model = std::make_shared<const MeshGeometry>(MeshGeometry{.mesh = mesh});
    const Basis right{.x = {0, 1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}};
    const Basis left{.x = {0, -1, 0}, .y = {0, 0, 1}, .z = {1, 0, 0}};
    for (const Basis& rotation : {right, left}) {
        const MeshInstance instance{.model = model, .placement = {.rotation = rotation}};
        int outward = 0;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[i];
            const Vec3 center = mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c];
            const Vec3 direction = rotated(center, instance.placement);
            const MeshHit hit{.t = 1, .triangle = i, .weights = Vec3(Real(1) / 3)};
            outward += dot(normal(instance, hit), direction) > 0;
            outward += dot(geometric_normal(instance, hit), direction) > 0;
        }
        CHECK(outward == 2 * int(mesh.triangles.size()));
    }
}
