// The BVH and a list give the same hits, for any shapes.
#include "common/bvh/bvh.hpp"
#include "common/geometry/bounds.hpp"
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/common/bvh/inputs.hpp"

#include <algorithm>

using namespace rt;

namespace {

void draw(Random& random, Sphere& sphere) {
    sphere = {.center = random.point(4), .radius = size_between(random, Real(0.01), 1)};
}

void draw(Random& random, Square& square) {
    square = {.center = random.point(4),
              .basis = random.coin() ? random.basis() : Basis{},
              .side = size_between(random, Real(0.01), 2)};
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

bool inside(const BoundingBox& box, Vec3 p) {
    return max(min(p, box.max), box.min) == p;
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
        if (!inside(wider, at(ray, *t)))
            return verdict(false, code(shape) + "\n  its box:  " + text(box.min) + " to " +
                                      text(box.max) + "\n  its hit:  " + text(at(ray, *t)) +
                                      "\n  of:       " + code(ray));
    }
    return {};
}

}  // namespace

TEMPLATE_TEST_CASE("a hierarchy and a list find the same hits, for all shapes (contract)", "",
                   Sphere, Triangle, Square, Cylinder, Cone) {
    CHECK(for_all(agrees_with_list<TestType>));
}

TEMPLATE_TEST_CASE("a shape's box contains every hit on it (contract)", "", Sphere, Triangle,
                   Square, Cylinder, Cone) {
    CHECK(for_all(box_holds_hits<TestType>, 2000));
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

TEST_CASE("a ray through the corner of a box hits it (Ize 2013)") {
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

TEST_CASE("the parts of a hierarchy: eight at most in each, and every leaf once (contract)") {
    for (const int count : {0, 1, 2, 9, 1000}) {
        std::vector<BoundingBox> boxes;
        for (int i = 0; i < count; ++i)
            boxes.push_back({.min = Vec3(Real(i)), .max = Vec3(Real(i + 1))});
        const Bvh hierarchy = hierarchy_of(boxes);
        const std::vector<Bvh::Part> parts = hierarchy.parts();
        CHECK(parts.empty() == (count == 0));
        std::vector<int> leaves(hierarchy.leaves().size()), children(parts.size());
        for (std::size_t place = 0; place < parts.size(); ++place) {
            if (parts[place].leaf) ++leaves.at(*parts[place].leaf);
            if (place == 0) continue;
            REQUIRE(parts[place].parent < place);
            CHECK_FALSE(parts[parts[place].parent].leaf);
            ++children[parts[place].parent];
        }
        CHECK(std::ranges::all_of(leaves, [](int times) { return times == 1; }));
        for (std::size_t place = 0; place < parts.size(); ++place) {
            const int fewest = parts[place].leaf ? 0 : 2;
            CHECK((children[place] >= fewest && children[place] <= (parts[place].leaf ? 0 : 8)));
        }
    }
}

TEST_CASE("nodes are as full as their areas permit, and not only near the root (contract)") {
    // If the widest part were split until there are eight, most of the nodes would have two leaves.
    std::vector<BoundingBox> boxes;
    for (int i = 0; i < 1024; ++i) {
        const Vec3 corner(Real(i % 32), Real(i / 32), 0);
        boxes.push_back({.min = corner, .max = corner + Vec3(1)});
    }
    const std::vector<Bvh::Part> parts = hierarchy_of(boxes).parts();
    const auto nodes = std::ranges::count_if(parts, [](const auto& part) { return !part.leaf; });
    CHECK(4 * nodes <= 1024);
}
