// The cost of a mesh that --shade cost shows.

#include "common/math/simd.hpp"
#include "common/render/pixel_values.hpp"

#include "tests/kit/catch.hpp"

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
