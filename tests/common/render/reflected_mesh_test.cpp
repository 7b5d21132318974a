// Normals of a mesh in a scene whose axes are left-handed.
#include "steps/step13_meshes/mesh_instance.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/meshes.hpp"

#include "common/math/vector.hpp"

#include <memory>

using namespace rt;

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
