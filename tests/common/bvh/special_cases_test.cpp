// A BVH and a packed mesh: rays along faces, invalid rays, and inputs without an area.
#include "common/bvh/bvh.hpp"
#include "common/bvh/mesh_bvh.hpp"
#include "common/geometry/bounds.hpp"

#include "tests/common/bvh/inputs.hpp"

using namespace rt;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// A plane face of many corners, cut into a fan of narrow triangles.
Mesh fan(Random& random, std::uint32_t corners) {
    const Vec3 center = random.point(10);
    const auto [x, y, z] = draw_basis(random);
    Mesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const Real angle = 2 * pi * Real(i) / Real(corners);
        mesh.vertices.push_back(center + Real(5) * (std::cos(angle) * x + std::sin(angle) * y));
    }
    for (std::uint32_t i = 2; i < corners; ++i) mesh.triangles.push_back({0, i - 1, i});
    return mesh;
}

}  // namespace

TEST_CASE("a ray that leaves a plane face does not hit it again (MRT §5)") {
    CHECK(for_all(
        [](Random& random) {
            const Mesh mesh = fan(random, 4 + std::uint32_t(random.below(1000)));
            const MeshBvh packed(mesh);
            const Triangle triangle = triangle_of(mesh, mesh.triangles.size() / 2);
            const Vec3 n = unit(cross(triangle.b - triangle.a, triangle.c - triangle.a));
            const Real far = projection_error(largest_component(packed.bounds()));
            for (int i = 0; i < 100; ++i) {
                const int inner =
                    2 + random.below(int(mesh.vertices.size()) - 3);  // an edge ends there
                const Vec3 point = mix(mesh.vertices[0], mesh.vertices[std::size_t(inner)],
                                       random.between(Real(0.01), Real(0.99)));
                Vec3 direction = random.point(1);
                if (dot(direction, n) < 0) direction = -direction;
                const Ray away{.origin = point + far * n, .direction = direction};
                if (packed.occludes(away, {}) || packed.nearest(away, {}))
                    return verdict(false, std::to_string(mesh.vertices.size()) +
                                              " corners, the first " + code(mesh.vertices[0]) +
                                              ": " + code(away));
                const Ray back{.origin = point + Real(5) * n, .direction = -n};
                if (!packed.occludes(back, {})) return verdict(false, "no hit: " + code(back));
            }
            return Verdict{};
        },
        200));
}

TEST_CASE("a ray along the faces of boxes hits them (contract)") {
    SECTION("a mesh: every vertex of a grid, from above") {
        constexpr std::uint32_t side = 16;
        const MeshBvh packed(grid(side));
        for (std::uint32_t x = 0; x <= side; ++x)
            for (std::uint32_t y = 0; y <= side; ++y) {
                const Ray ray{.origin = {Real(x), Real(y), 3}, .direction = {0, 0, -1}};
                INFO(code(ray));
                REQUIRE(packed.nearest(ray, {}));
                CHECK(packed.nearest(ray, {})->t == 3);
            }
    }
    SECTION("boxes: all that touch the line where four rows of a block meet") {
        std::vector<BoundingBox> boxes;
        for (int x = 0; x < 8; ++x)
            for (int y = 0; y < 8; ++y)
                for (int z = 0; z < 8; ++z)
                    boxes.push_back({.min = {Real(x), Real(y), Real(z)},
                                     .max = {Real(x + 1), Real(y + 1), Real(z + 1)}});
        const Bvh hierarchy = hierarchy_of(boxes);
        for (const Real zero : {Real(0), Real(-0.0)}) {
            const Ray ray{.origin = {-5, 3, 6}, .direction = {2, zero, zero}};
            const auto indices = visited(hierarchy, ray, {});
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
                const BoundingBox& box = boxes[i];
                const bool touches =
                    box.min.y <= 3 && 3 <= box.max.y && box.min.z <= 6 && 6 <= box.max.z;
                CHECK((!touches || indices.count(i) == 1));
            }
            CHECK(indices.size() < boxes.size() / 2);
        }
    }
}

TEST_CASE("an invalid ray misses everything, and quickly (contract)") {
    const Mesh ball = bumpy_ball(4);
    const MeshBvh packed(ball);
    std::vector<BoundingBox> boxes;
    for (std::size_t i = 0; i < ball.triangles.size(); ++i)
        boxes.push_back(bounds(triangle_of(ball, i)));
    const Bvh hierarchy = hierarchy_of(boxes);
    std::vector<Ray> rays = {{.origin = {0, 0, 0}, .direction = {0, 0, 0}},
                             {.origin = {0, 0, 5}, .direction = {0, 0, 0}}};
    for (const Real bad : {not_a_number, infinity, -infinity})
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            Ray ray{.origin = {0, 0, 5}, .direction = {Real(0.01), Real(0.02), -1}};
            ray.origin[axis] = bad;
            rays.push_back(ray);
            ray = {.origin = {0, 0, 5}, .direction = {Real(0.01), Real(0.02), -1}};
            ray.direction[axis] = bad;
            rays.push_back(ray);
        }
    for (const Ray& ray : rays) {
        INFO(code(ray));
        CHECK_FALSE(packed.nearest(ray, {}));
        CHECK_FALSE(packed.occludes(ray, {}));
        int visits = 0;
        RayBoxTestCache slabs(ray);
        CHECK_FALSE(hierarchy.any(slabs, {}, [&](std::uint32_t) { return ++visits < 0; }));
        CHECK(visits < 10'000);
    }
    const Ray good{.origin = {0, 0, 5}, .direction = {Real(0.01), Real(0.02), -1}};
    REQUIRE(packed.nearest(good, {}));
    for (const Interval interval :
         {Interval{not_a_number, 9}, Interval{0, not_a_number}, Interval{9, 1}})
        CHECK_FALSE(packed.nearest(good, interval));
}

TEST_CASE("nothing, or all in one place, is a hierarchy too (contract)") {
    const Ray ray{.origin = {Real(0.25), Real(0.25), 3}, .direction = {0, 0, -1}};
    SECTION("nothing") {
        CHECK(Bvh().empty());
        CHECK(hierarchy_of({}).empty());
        CHECK(visited(Bvh(), ray, {}).empty());
        CHECK_FALSE(MeshBvh().nearest(ray, {}));
        CHECK_FALSE(MeshBvh(Mesh{}).occludes(ray, {}));
        const BoundingBox box = MeshBvh(Mesh{}).bounds();
        CHECK(box.min.x > box.max.x);
    }
    SECTION("a hundred thousand times the same triangle") {
        Mesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
        mesh.triangles.assign(100'000, {0, 1, 2});
        CHECK(MeshBvh(mesh).nearest(ray, {})->t == 3);
    }
    SECTION("triangles without an area") {
        Mesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                  .triangles = {{0, 0, 0}, {0, 1, 1}, {2, 2, 1}, {0, 1, 2}, {1, 1, 1}}};
        REQUIRE(MeshBvh(mesh).nearest(ray, {}));
        CHECK(MeshBvh(mesh).nearest(ray, {})->triangle == 3);
    }
}
