// A packed mesh is watertight, and gives the hits of exact arithmetic.
#include "common/bvh/mesh_bvh.hpp"

#include "tests/common/bvh/inputs.hpp"
#include "tests/common/bvh/scalar_lanes.hpp"
#include "tests/kit/exact.hpp"

#include <algorithm>

using namespace rt;

namespace {

Mesh placed(Mesh mesh, Real scale, Vec3 translation) {
    for (Vec3& vertex : mesh.vertices) vertex = scale * vertex + translation;
    return mesh;
}

/// The mesh with the coordinates of a file.
Mesh of_floats(Mesh mesh) {
    for (Vec3& vertex : mesh.vertices) vertex = Vec3(glm::vec3(vertex));
    return mesh;
}

Verdict keeps_every_ray(const Mesh& mesh, Real scale, Vec3 center, int rays) {
    const MeshBvh packed(mesh);
    return for_all(
        [&](Random& random) {
            const Ray ray = draw_shot(random, mesh, scale, center);
            return verdict(packed.nearest(ray, {}) && packed.occludes(ray, {}),
                           "from inside the closed surface, no hit: " + code(ray));
        },
        rays);
}

/// A hit in arithmetic with more digits, or the result that it is uncertain.
struct Certain {
    bool sure = true;
    std::optional<Exact> t;
};

Certain exact_hit(const Ray& ray, const Triangle& triangle) {
    using Long = glm::vec<3, Exact>;
    constexpr Exact close_call = tolerance;
    const Long o(ray.origin);
    const Long d(ray.direction);
    const Long a = Long(triangle.a) - o;
    const Long b = Long(triangle.b) - o;
    const Long c = Long(triangle.c) - o;
    const Long areas(dot(d, cross(b, c)), dot(d, cross(c, a)), dot(d, cross(a, b)));
    const Exact sum = areas.x + areas.y + areas.z;
    const Long n = cross(b - a, c - a);
    if (std::abs(sum) < close_call * length(d) * length(n)) return {.sure = false};
    const Long weights = areas / sum;
    const Exact least = std::min(weights.x, std::min(weights.y, weights.z));
    if (std::abs(least) < 10 * close_call) return {.sure = false};
    const Exact t = dot(a, n) / dot(d, n);
    if (least < 0 || t <= 0) return {};
    return {.t = t};
}

/// Triangles anywhere: the packed mesh and wider arithmetic agree on the hit, the triangle and its
/// weights.
Verdict agrees_with_wider_arithmetic(Random& random) {
    Mesh mesh;
    const auto count = std::uint32_t(1 + random.below(100));
    for (std::uint32_t i = 0; i < count; ++i) {
        Triangle triangle;
        draw(random, triangle);
        mesh.vertices.insert(mesh.vertices.end(), {triangle.a, triangle.b, triangle.c});
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const MeshBvh packed(mesh);
    const auto target = std::size_t(random.below(int(count)));
    const Ray ray = draw_ray(random, bounds(triangle_of(mesh, target)));
    std::optional<Exact> expected;
    for (std::size_t i = 0; i < count; ++i) {
        const auto [sure, t] = exact_hit(ray, triangle_of(mesh, i));
        if (!sure) return {};
        if (t && (!expected || *t < *expected)) expected = t;
    }
    const auto got = packed.nearest(ray, {});
    const std::string asked = code(ray) + " in " + std::to_string(count) + " triangles";
    if (got.has_value() != expected.has_value() || packed.occludes(ray, {}) != got.has_value())
        return verdict(false, asked + (expected ? ": no hit" : ": a false hit"));
    if (!got) return {};
    const auto [a, b, c] = triangle_of(mesh, got->triangle);
    const Vec3 point = got->weights.x * a + got->weights.y * b + got->weights.z * c;
    const Real far = 100 * tolerance * std::max(Real(1), length(ray.origin));
    return verdict(close(got->t, Real(*expected)) && length(point - at(ray, got->t)) < far &&
                       close(got->weights.x + got->weights.y + got->weights.z, 1),
                   asked + "\n  got:      " + text(got->t) + " at " + text(got->weights) +
                       "\n  expected: " + text(Real(*expected)));
}

/// Lanes of every width have the same results, though their hierarchies differ.
void check_other_lanes(const Mesh& ball) {
    const MeshBvh packed(ball);
    std::vector<Ray> rays;
    Random random(1);
    for (int i = 0; i < 20'000; ++i)
        rays.push_back(i % 2 == 0 ? draw_shot(random, ball, 1, Vec3(0))
                                  : Ray{.origin = random.point(3), .direction = random.point(1)});
    for (const auto& expected :
         {hits_of_scalar_lanes(ball, rays), hits_of_vector_lanes(ball, rays)})
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto got = packed.nearest(rays[i], {});
            INFO(code(rays[i]));
            REQUIRE(got.has_value() == expected[i].has_value());
            if (!got) continue;
            CHECK(got->t == expected[i]->t);
            CHECK(got->triangle == expected[i]->triangle);
            CHECK(got->weights == expected[i]->weights);
        }
}

/// The mesh, and behind it the same triangles again in the reverse order.
Mesh twice(Mesh mesh) {
    const std::vector once = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), once.rbegin(), once.rend());
    return mesh;
}

}  // namespace

TEST_CASE("no ray is lost at an edge or a vertex of a closed mesh (Woop 2013)") {
    const Mesh ball = bumpy_ball(5);
    CHECK(keeps_every_ray(ball, 1, Vec3(0), 200'000));

    SECTION("nor if all coordinates are floats") {
        CHECK(keeps_every_ray(of_floats(ball), 1, Vec3(0), 50'000));
    }
    SECTION("nor far from 0") {
        const Vec3 far(1000, -2000, 500);
        CHECK(keeps_every_ray(placed(ball, 1, far), 1, far, 50'000));
    }
    SECTION("nor very far from 0, where the vertices lie on a coarse grid") {
        const Vec3 far(Real(1e5) * 1000 * unit_roundoff / Real(0x1p-24));
        CHECK(keeps_every_ray(placed(bumpy_ball(3), 1000, far), 1000, far, 50'000));
    }
    SECTION("nor on a small one") {
        CHECK(keeps_every_ray(placed(ball, Real(1e-6), Vec3(0)), Real(1e-6), Vec3(0), 50'000));
    }
    SECTION("nor on a large one") {
        CHECK(keeps_every_ray(placed(ball, Real(1e6), Vec3(0)), Real(1e6), Vec3(0), 50'000));
    }
}

TEST_CASE("no ray is lost at a surface that is as nothing beside the rest of its mesh (contract)") {
    const Mesh small_ball = bumpy_ball(2);
    for (const int decades : {-6, -9, -12, -15, -20, -30, -111, -150, -250}) {
        const Real scale = std::pow(Real(10), Real(decades));
        if (scale < std::numeric_limits<Real>::min() * 1'000'000) continue;  // no float
        // Around it, a mesh of size 1, whose scale is used for packing all of it.
        const Mesh small = placed(small_ball, scale, Vec3(0));
        Mesh both = small;
        const Mesh around = placed(small_ball, 1, Vec3(0));
        const auto first = std::uint32_t(both.vertices.size());
        both.vertices.insert(both.vertices.end(), around.vertices.begin(), around.vertices.end());
        for (const auto& [a, b, c] : around.triangles)
            both.triangles.push_back({first + a, first + b, first + c});
        const MeshBvh packed(both);
        CAPTURE(decades);
        CHECK(for_all([&](Random& random) {
            const Ray ray = draw_shot(random, small, scale, Vec3(0));
            const auto got = packed.nearest(ray, {});
            return verdict(got && got->triangle < small.triangles.size() &&
                               packed.occludes(ray, {.max = 2 * got->t}),
                           "from inside the closed surface, no hit: " + code(ray));
        }));
    }
}

TEST_CASE("a packed mesh gives the hit that exact arithmetic gives (contract)") {
    // No wider type, no judge: as in double on Apple's processors.
    if (Exact(1) + Exact(unit_roundoff) / 4 == 1) return;
    CHECK(for_all(agrees_with_wider_arithmetic, 3000));
}

TEST_CASE("a scale changes no bit, however large or small (contract)") {
    // Areas are squares, and t a quotient of cubes: 2^±100 would over- or underflow in float.
    const Mesh ball = bumpy_ball(2);
    const MeshBvh packed(ball);
    for (const int power : {-100, -60, 60, 100}) {
        const Real scale = std::ldexp(Real(1), power);
        const MeshBvh scaled(placed(ball, scale, Vec3(0)));
        CHECK(for_all([&](Random& random) {
            const Ray ray{.origin = random.point(2), .direction = random.direction()};
            const auto expected = packed.nearest(ray, {});
            const auto got = scaled.nearest(
                {.origin = scale * ray.origin, .direction = scale * ray.direction}, {});
            return verdict(
                got.has_value() == expected.has_value() &&
                    (!got || (got->t == expected->t && got->triangle == expected->triangle)),
                code(ray) + " times 2^" + std::to_string(power));
        }));
    }
}

TEST_CASE("a mesh of floats has the hits of one that requires Real (contract)") {
    const Mesh ball = of_floats(bumpy_ball(4));
    // Three equal points have no area, and no ray hits them. They are not floats.
    Mesh wider = ball;
    const auto point = std::uint32_t(ball.vertices.size());
    wider.vertices.emplace_back(Real(1) / 3);
    wider.triangles.push_back({point, point, point});
    const MeshBvh packed(ball);
    const MeshBvh expected(wider);
    CHECK(for_all([&](Random& random) {
        const Ray ray = random.coin()
                            ? draw_shot(random, ball, 1, Vec3(0))
                            : Ray{.origin = random.point(3), .direction = random.point(1)};
        const auto a = packed.nearest(ray, {});
        const auto b = expected.nearest(ray, {});
        // At an edge, the two may report different triangles at the same t.
        return verdict(a.has_value() == b.has_value() && (!a || a->t == b->t) &&
                           packed.occludes(ray, {}) == expected.occludes(ray, {}),
                       code(ray));
    }));
}

TEST_CASE("an interval is open for a mesh too (contract)") {
    const MeshBvh packed(grid(4));
    const Ray ray{.origin = {Real(1.25), Real(1.5), 2}, .direction = {0, 0, -1}};
    CHECK(packed.nearest(ray, {})->t == 2);
    CHECK_FALSE(packed.nearest(ray, {.max = 2}));
    CHECK_FALSE(packed.nearest(ray, {.min = 2}));
    CHECK_FALSE(packed.occludes(ray, {.max = 2}));
    CHECK_FALSE(packed.occludes(ray, {.min = 2}));
    CHECK(packed.occludes(ray, {.min = Real(1.75), .max = Real(2.25)}));
}

TEST_CASE("lanes of every width give the same bits (contract)") {
    check_other_lanes(bumpy_ball(4));
    check_other_lanes(of_floats(twice(bumpy_ball(4))));
}

TEST_CASE("of several triangles at one t, a mesh reports the first (contract)") {
    constexpr std::uint32_t side = 16;
    const Mesh cells = grid(side);
    const MeshBvh packed(twice(cells));
    for (std::uint32_t x = 0; x <= side; ++x)
        for (std::uint32_t y = 0; y <= side; ++y) {
            const Ray ray{.origin = {Real(x), Real(y), 3}, .direction = {0, 0, -1}};
            // The first triangle with the vertex below the ray.
            const std::uint32_t vertex = y * (side + 1) + x;
            const auto first = std::ranges::find_if(cells.triangles, [&](const auto& corners) {
                return std::ranges::find(corners, vertex) != corners.end();
            });
            INFO(code(ray));
            REQUIRE(packed.nearest(ray, {}));
            CHECK(packed.nearest(ray, {})->triangle == first - cells.triangles.begin());
        }
}
