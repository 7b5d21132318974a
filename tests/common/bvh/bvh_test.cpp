// The BVH and a list give the same hits, for any shapes; and a packed mesh is watertight.
#include "common/bvh/bvh.hpp"
#include "common/bvh/mesh_bvh.hpp"
#include "common/geometry/bounds.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/common/bvh/scalar_lanes.hpp"
#include "tests/kit/shape_checks.hpp"

#include <algorithm>
#include <map>
#include <set>

using namespace rt;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// A number with a uniform logarithm: small and large shapes alike.
Real size_between(Random& random, Real low, Real high) {
    return low * std::pow(high / low, random.between(0, 1));
}

void draw(Random& random, Sphere& sphere) {
    sphere = {.center = random.point(4), .radius = size_between(random, Real(0.01), 1)};
}

void draw(Random& random, Triangle& triangle) {
    const Vec3 a = random.point(4);
    const Real size = size_between(random, Real(0.01), 2);
    triangle = {.a = a, .b = a + size * random.direction(), .c = a + size * random.direction()};
}

void draw(Random& random, Square& square) {
    square = {.center = random.point(4),
              .basis = random.coin() ? random.basis() : Basis{},
              .side = size_between(random, Real(0.01), 2)};
}

Vec3 draw_axis(Random& random) {
    Vec3 axis(0);
    if (random.coin()) return random.direction();
    axis[random.below(3)] = random.coin() ? 1 : -1;
    return axis;
}

void draw(Random& random, Cylinder& cylinder) {
    cylinder = {.center = random.point(4),
                .axis = draw_axis(random),
                .radius = size_between(random, Real(0.01), 1),
                .height = size_between(random, Real(0.01), 4)};
}

void draw(Random& random, Cone& cone) {
    cone = {.apex = random.point(4),
            .axis = draw_axis(random),
            .radius = size_between(random, Real(0.01), 1),
            .height = size_between(random, Real(0.01), 4)};
}

template <class Shape>
std::vector<Shape> draw_shapes(Random& random) {
    std::vector<Shape> shapes(std::size_t(1 + random.below(60)));
    for (Shape& shape : shapes) draw(random, shape);
    return shapes;
}

template <class Shape>
Bvh hierarchy_over(const std::vector<Shape>& shapes, const BoundingBox& scene = {}) {
    return Bvh(
        shapes.size(), [&shapes](std::size_t i) { return bounds(shapes[i]); },
        Bvh::Leaves::one_by_one, scene);
}

Bvh hierarchy_of(const std::vector<BoundingBox>& boxes) {
    return Bvh(boxes.size(), [&boxes](std::size_t i) { return boxes[i]; });
}

/// A ray from anywhere, along an axis or in any direction, to a corner, the middle of a face or a
/// point of the box: at the points where a shape touches its box, a box too small would lose it.
Ray draw_ray(Random& random, const BoundingBox& box) {
    Vec3 share;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        share[axis] = random.coin() ? Real(random.below(3)) / 2 : random.between(0, 1);
    const Vec3 aim = box.min + share * (box.max - box.min);
    Vec3 away = random.coin() ? random.direction() : draw_axis(random);
    return {.origin = aim + size_between(random, Real(0.1), 100) * away,
            .direction = -random.power_of_two() * away};
}

/// The closest hit of a list, and its shape.
template <class Shape>
std::optional<Real> by_list(const std::vector<Shape>& shapes, const Ray& ray, Interval interval) {
    std::optional<Real> nearest;
    for (const Shape& shape : shapes)
        if (const auto t = intersect(ray, shape, interval)) {
            nearest = t;
            interval.max = *t;
        }
    return nearest;
}

template <class Shape>
std::optional<Real> by_hierarchy(const Bvh& hierarchy, const std::vector<Shape>& shapes,
                                 const Ray& ray, RayBoxTestCache& slabs, Interval interval) {
    std::optional<Real> nearest;
    hierarchy.nearest(slabs, interval, [&](std::uint32_t index) {
        const auto t = intersect(ray, shapes[index], interval);
        if (!t) return;
        nearest = t;
        interval.max = *t;
    });
    return nearest;
}

/// The closest hit of the BVH equals the list's, to the last bit, since the same test computes
/// both; and any() agrees. The ray was prepared for another BVH before, which may have the same
/// frame.
template <class Shape>
Verdict agrees_with_list(Random& random) {
    const std::vector<Shape> shapes = draw_shapes<Shape>(random);
    const Real size = std::exp2(Real(random.below(12)));
    const BoundingBox scene{.min = Vec3(-size), .max = Vec3(size)};
    const Bvh hierarchy = hierarchy_over(shapes, scene);
    const Bvh other = hierarchy_over(draw_shapes<Shape>(random), scene);
    for (int i = 0; i < 20; ++i) {
        const Shape& target = shapes[std::size_t(random.below(int(shapes.size())))];
        const Ray ray = draw_ray(random, bounds(target));
        Interval interval;
        if (random.coin()) interval.max = random.between(0, 4);
        const auto expected = by_list(shapes, ray, interval);
        RayBoxTestCache slabs(ray);
        (void)other.any(slabs, interval, [](std::uint32_t) { return false; });
        const auto got = by_hierarchy(hierarchy, shapes, ray, slabs, interval);
        const bool any = hierarchy.any(slabs, interval, [&](std::uint32_t index) {
            return intersect(ray, shapes[index], interval).has_value();
        });
        if (got != expected || any != expected.has_value())
            return verdict(false, code(ray) + ", " + code(interval) + " in " +
                                      std::to_string(shapes.size()) + " shapes\n  got:      " +
                                      got_text(got) + ", any: " + (any ? "true" : "false") +
                                      "\n  expected: " + got_text(expected));
    }
    return {};
}

template <class Shape>
bool inside(const BoundingBox& box, const Shape&, Vec3 p) {
    return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x &&
           p.y <= box.max.y && p.z <= box.max.z;
}

/// The hit of the stage lies in the shape's box.
template <class Shape>
Verdict box_holds_hits(Random& random) {
    Shape shape;
    draw(random, shape);
    const Transform transform{.scale = random.power_of_two(), .translation = random.point(100)};
    shape = transformed(shape, transform);
    const BoundingBox box = bounds(shape);
    for (int i = 0; i < 20; ++i) {
        const Ray ray = draw_ray(random, box);
        const auto t = intersect(ray, shape, {});
        // The point itself is rounded once more, relative to the distance.
        if (!t) continue;
        const Vec3 slack(4 * unit_roundoff * *t * length(ray.direction));
        const BoundingBox wider{.min = box.min - slack, .max = box.max + slack};
        if (!inside(wider, shape, at(ray, *t)))
            return verdict(false, code(shape) + "\n  its box:  " + text(box.min) + " to " +
                                      text(box.max) + "\n  its hit:  " + text(at(ray, *t)) +
                                      "\n  of:       " + code(ray));
    }
    return {};
}

// Meshes.

Mesh octahedron() {
    return {.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            .triangles = {{0, 2, 4},
                          {2, 1, 4},
                          {1, 3, 4},
                          {3, 0, 4},
                          {2, 0, 5},
                          {1, 2, 5},
                          {3, 1, 5},
                          {0, 3, 5}}};
}

/// Four triangles for one, and the vertices on the unit sphere.
Mesh refined(const Mesh& mesh) {
    Mesh finer{.vertices = mesh.vertices};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t p, std::uint32_t q) {
        const auto [found, is_new] =
            middles.try_emplace(std::minmax(p, q), std::uint32_t(finer.vertices.size()));
        if (is_new) finer.vertices.push_back(normalize(mesh.vertices[p] + mesh.vertices[q]));
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b);
        const std::uint32_t bc = middle(b, c);
        const std::uint32_t ca = middle(c, a);
        finer.triangles.insert(finer.triangles.end(),
                               {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return finer;
}

/// A closed surface of 8 · 4^times triangles around 0, between 0.8 and 1.2 from it.
Mesh bumpy_ball(int times) {
    Mesh mesh = octahedron();
    for (int i = 0; i < times; ++i) mesh = refined(mesh);
    for (Vec3& p : mesh.vertices)
        p *= 1 + Real(0.2) * std::sin(9 * p.x) * std::sin(7 * p.y + 1) * std::sin(8 * p.z + 2);
    return mesh;
}

Mesh placed(Mesh mesh, Real scale, Vec3 translation) {
    for (Vec3& vertex : mesh.vertices) vertex = scale * vertex + translation;
    return mesh;
}

Triangle triangle_of(const Mesh& mesh, std::size_t i) {
    const auto [a, b, c] = mesh.triangles[i];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// From inside a ball around the center, at a vertex or a point of an edge.
Ray draw_shot(Random& random, const Mesh& mesh, Real scale, Vec3 center) {
    const auto corners = mesh.triangles[std::size_t(random.below(int(mesh.triangles.size())))];
    const auto corner = std::size_t(random.below(3));
    const Vec3 p = mesh.vertices[corners[corner]];
    const Vec3 q = mesh.vertices[corners[(corner + 1) % 3]];
    const Vec3 aim = random.coin() ? p : p + random.between(0, 1) * (q - p);
    const Vec3 origin = center + scale * random.point(Real(0.3));
    return {.origin = origin, .direction = random.power_of_two() * (aim - origin)};
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
    std::optional<long double> t;
};

Certain exact_hit(const Ray& ray, const Triangle& triangle) {
    using Long = glm::vec<3, long double>;
    constexpr long double close_call = tolerance;
    const Long o(ray.origin);
    const Long d(ray.direction);
    const Long a = Long(triangle.a) - o;
    const Long b = Long(triangle.b) - o;
    const Long c = Long(triangle.c) - o;
    const Long areas(dot(d, cross(b, c)), dot(d, cross(c, a)), dot(d, cross(a, b)));
    const long double sum = areas.x + areas.y + areas.z;
    const Long n = cross(b - a, c - a);
    if (std::abs(sum) < close_call * length(d) * length(n)) return {.sure = false};
    const Long weights = areas / sum;
    const long double least = std::min(weights.x, std::min(weights.y, weights.z));
    if (std::abs(least) < 10 * close_call) return {.sure = false};
    const long double t = dot(a, n) / dot(d, n);
    if (least < 0 || t <= 0) return {};
    return {.t = t};
}

/// Triangles anywhere: the packed mesh and long double agree on the hit, the triangle and its
/// weights.
Verdict agrees_with_long_double(Random& random) {
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
    std::optional<long double> expected;
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

/// A square grid of side × side cells of side 1 in the plane z = 0, from (0, 0).
Mesh grid(std::uint32_t side) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x) mesh.vertices.push_back({Real(x), Real(y), 0});
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t corner = y * (side + 1) + x;
            const std::uint32_t above = corner + side + 1;
            mesh.triangles.push_back({corner, corner + 1, above});
            mesh.triangles.push_back({corner + 1, above + 1, above});
        }
    return mesh;
}

std::set<std::uint32_t> visited(const Bvh& hierarchy, const Ray& ray, Interval interval) {
    std::set<std::uint32_t> indices;
    RayBoxTestCache slabs(ray);
    hierarchy.nearest(slabs, interval, [&](std::uint32_t index) { indices.insert(index); });
    return indices;
}

}  // namespace

TEST_CASE("a hierarchy and a list find the same hits, for all shapes (contract)") {
    CHECK(for_all(agrees_with_list<Sphere>));
    CHECK(for_all(agrees_with_list<Triangle>));
    CHECK(for_all(agrees_with_list<Square>));
    CHECK(for_all(agrees_with_list<Cylinder>));
    CHECK(for_all(agrees_with_list<Cone>));
}

TEST_CASE("a shape's box contains every hit on it (contract)") {
    CHECK(for_all(box_holds_hits<Sphere>, 2000));
    CHECK(for_all(box_holds_hits<Triangle>, 2000));
    CHECK(for_all(box_holds_hits<Square>, 2000));
    CHECK(for_all(box_holds_hits<Cylinder>, 2000));
    CHECK(for_all(box_holds_hits<Cone>, 2000));
}

TEST_CASE("a shape's box is hardly wider than the shape (contract)") {
    const BoundingBox ball = bounds(Sphere{.center = {1, 2, 3}, .radius = 2});
    CHECK(gives("box of a ball", ball.min, Vec3(-1, 0, 1)));
    CHECK(gives("box of a ball", ball.max, Vec3(3, 4, 5)));
    const BoundingBox tube = bounds(Cylinder{.axis = {0, 0, 1}, .radius = 1, .height = 6});
    CHECK(gives("box of a tube", tube.max, Vec3(1, 1, 3)));
    const BoundingBox cone = bounds(Cone{.axis = {1, 0, 0}, .radius = 2, .height = 3});
    CHECK(gives("box of a cone", cone.min, Vec3(0, -2, -2)));
    CHECK(gives("box of a cone", cone.max, Vec3(3, 2, 2)));
    const BoundingBox square = bounds(Square{.center = {0, 0, 5}, .side = 4});
    CHECK(gives("box of a square", square.max, Vec3(2, 2, 5)));
}

TEST_CASE("no ray is lost at an edge or a vertex of a closed mesh (Woop 2013)") {
    const Mesh ball = bumpy_ball(5);
    CHECK(keeps_every_ray(ball, 1, Vec3(0), 200'000));

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
    CHECK(for_all(agrees_with_long_double, 3000));
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

TEST_CASE("a ray along the faces of boxes meets them (contract)") {
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

TEST_CASE("a ray through the corner of a box meets it (Ize 2013)") {
    // Whole numbers, times a power of two: the ray passes through the corner exactly, and often
    // through no other point of the box. It starts near or far, at any scale. Rounded slabs without
    // padding miss it two times in a hundred.
    const auto whole_point = [](Random& random, int reach) {
        const auto whole = [&] { return Real(random.below(2 * reach + 1) - reach); };
        return Vec3(whole(), whole(), whole());
    };
    CHECK(for_all(
        [&](Random& random) {
            std::vector<BoundingBox> boxes;
            for (int i = 0; i < 8; ++i) {
                const Vec3 corner = whole_point(random, 64);
                boxes.push_back(
                    merged(BoundingBox{.min = corner, .max = corner}, whole_point(random, 64)));
            }
            const auto target = std::uint32_t(random.below(8));
            Vec3 corner = boxes[target].min;
            for (glm::length_t axis = 0; axis < 3; ++axis)
                if (random.coin()) corner[axis] = boxes[target].max[axis];
            const Vec3 direction = whole_point(random, 9);
            if (direction == Vec3(0)) return Verdict{};
            const Real steps = Real(1 + random.below(1 << random.below(18)));
            const Real scale = std::ldexp(Real(1), random.below(121) - 60);
            for (BoundingBox& box : boxes) box = {.min = scale * box.min, .max = scale * box.max};
            const Ray ray{.origin = scale * (corner - steps * direction),
                          .direction = std::ldexp(Real(1), random.below(41) - 20) * direction};
            return verdict(visited(hierarchy_of(boxes), ray, {}).count(target) == 1,
                           code(ray) + " misses the box from " + text(boxes[target].min) + " to " +
                               text(boxes[target].max) + " whose corner it passes through");
        },
        20'000));
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

TEST_CASE("boxes may be huge, endless, or each half of the last (contract)") {
    SECTION("huge: areas overflow") {
        for (const Real size : {Real(1e18), std::numeric_limits<Real>::max() / 16}) {
            std::vector<BoundingBox> boxes;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 corner(size / 1000 * Real(i), 0, 0);
                boxes.push_back({.min = corner, .max = corner + Vec3(size / 2000)});
            }
            const Bvh hierarchy = hierarchy_of(boxes);
            const Ray down{.origin = {size / 1000 * Real(500.25), size / 4000, size},
                           .direction = {0, 0, -1}};
            const auto indices = visited(hierarchy, down, {});
            CHECK(indices.count(500) == 1);
            CHECK(indices.size() < 20);
        }
    }
    SECTION("endless") {
        std::vector<BoundingBox> boxes(100, {.min = Vec3(-infinity), .max = Vec3(infinity)});
        boxes.resize(200, {.min = Vec3(-1), .max = Vec3(1)});
        CHECK(visited(hierarchy_of(boxes), {.origin = {5, 5, 5}, .direction = {0, 0, 1}}, {})
                  .size() >= 100);
    }
    SECTION("each half of the last: as deep a tree as there can be") {
        std::vector<BoundingBox> boxes;
        for (int i = 0; i < 100'000; ++i) {
            Vec3 corner(0);
            corner[i % 3] = std::ldexp(Real(1), -(i % (-std::numeric_limits<Real>::min_exponent)));
            boxes.push_back({.min = corner, .max = corner});
        }
        const Ray ray{.origin = {-1, 0, 0}, .direction = {1, 0, 0}};
        CHECK(visited(hierarchy_of(boxes), ray, {}).size() > 30'000);
    }
}

TEST_CASE("two builds of a mesh large enough for threads are the same (contract)") {
    std::vector<BoundingBox> boxes;
    Random random(1);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 corner = random.point(10);
        boxes.push_back({.min = corner, .max = corner + Vec3(Real(0.1))});
    }
    const Bvh first = hierarchy_of(boxes);
    const Bvh second = hierarchy_of(boxes);
    CHECK(std::ranges::equal(first.leaves(), second.leaves(),
                             [](const Leaf& a, const Leaf& b) { return a.indices == b.indices; }));
}

TEST_CASE("lanes one after the other give the same bits (contract)") {
    const Mesh ball = bumpy_ball(4);
    const MeshBvh packed(ball);
    std::vector<Ray> rays;
    Random random(1);
    for (int i = 0; i < 20'000; ++i)
        rays.push_back(i % 2 == 0 ? draw_shot(random, ball, 1, Vec3(0))
                                  : Ray{.origin = random.point(3), .direction = random.point(1)});
    const auto expected = hits_without_vectors(ball, rays);
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
