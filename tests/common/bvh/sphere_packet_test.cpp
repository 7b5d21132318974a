// Tests of bounding spheres: they leave out no shape that a ray hits, and most of the others.
#include "common/geometry/bounds.hpp"
#include "common/scene/primitives.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/spots.hpp"

using namespace rt;

namespace {

bool is_near(const Ray& ray, const BoundingSphere& ball) {
    return BoundingSphereSet(std::array{ball}).candidates(ray) != 0;
}

/// A ray to the point from near or far away, in any direction or at right angles to the line from
/// the sphere's center, so that it grazes a sphere that ends there.
Ray draw_ray(Random& random, Vec3 point, const BoundingSphere& ball) {
    Vec3 way = random.direction();
    if (random.coin()) way = unit(cross(way, point - ball.center));
    const Real size = spread(random, -8, 8);  // with a direction of any length, from any distance
    return {.origin = point - ball.radius * spread(random, -3, 7) * way, .direction = size * way};
}

/// Anywhere, and of any size.
Transform draw_motion(Random& random) {
    return {.scale = spread(random, -6, 6), .translation = spread(random, -6, 6) * random.point(1)};
}

template <class Shape>
Verdict no_hit_is_lost(Random& random) {
    const Spot<Shape> spot = draw(random, Shape());
    const Transform transform = draw_motion(random);
    const Shape shape = transformed(spot.shape, transform);
    const BoundingSphere ball = bounding_sphere(shape);
    for (int i = 0; i < 20; ++i) {
        const Ray ray = draw_ray(random, transformed(spot.point, transform), ball);
        if (intersect(ray, shape, {}) && !is_near(ray, ball))
            return verdict(false, code(ray) + " hits " + code(shape));
    }
    return {};
}

/// A line that passes well inside of the sphere is near it, for any overflow or underflow of
/// products.
Verdict is_near_at_any_size(Random& random) {
    constexpr int most = std::numeric_limits<Real>::max_exponent - 30;
    const auto [x, y, z] = random.basis();
    const Real size = std::ldexp(random.between(1, 2), random.below(2 * most) - most);
    const Real length = std::ldexp(random.between(1, 2), random.below(2 * most) - most);
    const Vec3 off = random.between(Real(0.5), Real(0.99)) * x + random.between(-4, 4) * z;
    const BoundingSphere ball{.center = Vec3(0), .radius = size};
    const Ray ray{.origin = size * off, .direction = length * z};
    return verdict(is_near(ray, ball), code(ray) + " passes a ball of radius " + code(size));
}

/// The bounding sphere of a shape of size 1 at 0 has this radius.
template <class Shape>
void check_reach(const Shape& shape, Vec3 center, Real reach) {
    const BoundingSphere ball = bounding_sphere(shape);
    CHECK(distance(ball.center, center) <= 8 * unit_roundoff);
    CHECK(ball.radius >= reach);
    CHECK(ball.radius <= reach * (1 + 64 * unit_roundoff));
}

template <class Shape>
PrimitiveList<Shape> draw_items(Random& random, int count) {
    PrimitiveList<Shape> primitives;
    for (int i = 0; i < count; ++i) {
        const Transform transform{.scale = Real(0.25), .translation = random.point(1)};
        primitives.push_back({.shape = transformed(draw(random, Shape()).shape, transform)});
    }
    return primitives;
}

/// The number of tested shapes of a list for one ray, and the closest hit among them.
struct Asked {
    int count = 0;
    Real t = infinity;
};

template <class Shape>
Asked nearest(const PrimitiveList<Shape>& primitives, const Ray& ray) {
    RayBoxTestCache slabs(ray);
    Interval interval;
    Asked asked;
    primitives.traverse(slabs, interval, [&](const Primitive<Shape>& primitive) {
        ++asked.count;
        if (const auto t = intersect(ray, primitive.shape, interval)) interval.max = *t;
    });
    asked.t = interval.max;
    return asked;
}

template <class Shape>
bool any(const PrimitiveList<Shape>& primitives, const Ray& ray) {
    RayBoxTestCache slabs(ray);
    return primitives.traverse_any(slabs, {}, [&ray](const Primitive<Shape>& primitive) {
        return intersect(ray, primitive.shape, {}).has_value();
    });
}

/// However they are arranged. More than 64 have no balls.
template <class Shape>
Verdict finds_the_same(Random& random) {
    const PrimitiveList<Shape> list = draw_items<Shape>(random, 1 + random.below(70));
    PrimitiveList<Shape> in_balls = list;
    PrimitiveList<Shape> in_hierarchy = list;
    in_balls.build_acceleration({.hierarchy_from = Acceleration::never});
    in_hierarchy.build_acceleration({.hierarchy_from = 1});
    for (int i = 0; i < 20; ++i) {
        const Ray ray{.origin = Real(3) * random.direction(), .direction = random.direction()};
        const Asked by_list = nearest(list, ray);
        const bool blocked = by_list.t != infinity;
        const bool agree = nearest(in_balls, ray).t == by_list.t &&
                           nearest(in_hierarchy, ray).t == by_list.t &&
                           any(in_balls, ray) == blocked && any(in_hierarchy, ray) == blocked;
        if (!agree) return verdict(false, code(ray) + " among " + std::to_string(list.size()));
    }
    return {};
}

}  // namespace

TEMPLATE_TEST_CASE("balls: no shape that a ray hits is left out", "", Sphere, Triangle, Square,
                   Cylinder, Cone, OrientedBox) {
    CHECK(for_all(no_hit_is_lost<TestType>, 10000));
}

TEST_CASE("balls: as small as a shape lets them be") {
    check_reach(Sphere{.radius = Real(0.75)}, Vec3(0), Real(0.75));
    check_reach(Square{.side = 2}, Vec3(0), std::sqrt(Real(2)));
    check_reach(Cylinder{.radius = Real(0.75), .height = 2}, Vec3(0), Real(1.25));
    check_reach(OrientedBox{.half_size = {Real(0.25), Real(0.5), 1}}, Vec3(0),
                std::sqrt(Real(21)) / 4);
    // A right triangle with sides 3, 4 and 5 represents the cone: the sphere around its apex and
    // rim.
    check_reach(Cone{.radius = 3, .height = 4}, Vec3(0, Real(3.125), 0), Real(3.125));
    check_reach(Cone{.radius = 4, .height = 3}, Vec3(0, 3, 0), 4);  // a blunt one: around its rim
    check_reach(Triangle{.a = {1, 0, 0}, .b = {0, 1, 0}, .c = {0, 0, 1}}, Vec3(Real(1) / 3),
                std::sqrt(Real(6)) / 3);
}

TEST_CASE("balls: a ray misses a sphere that its line misses") {
    const BoundingSphere ball{.center = {1, 2, 3}, .radius = Real(0.5)};
    for (const Real distance : {Real(1), Real(30)})
        for (const Real length : {Real(1e-6), Real(1), Real(1e6)})
            for (const Real off : {Real(0.499), Real(0.51)}) {
                const Ray ray{.origin = {1 + off, 2, 3 - distance}, .direction = {0, 0, length}};
                CHECK(is_near(ray, ball) == (off < ball.radius));
            }
    // The test is about the line, not the half-line: a sphere behind the origin counts.
    CHECK(is_near({.origin = {1, 2, 5}, .direction = {0, 0, 1}}, ball));
}

TEST_CASE("balls: each has its own bit, up to 64") {
    std::vector<BoundingSphere> row;
    for (std::size_t count = 1; count <= BoundingSphereSet::most; ++count) {
        row.push_back({.center = {Real(count), 0, 0}, .radius = Real(0.25)});
        const BoundingSphereSet balls(row);
        const Ray last{.origin = {Real(count), 0, 5}, .direction = {0, 0, -1}};
        CHECK(balls.candidates(last) == std::uint64_t(1) << (count - 1));
        const Ray all{.origin = {-1, 0, 0}, .direction = {1, 0, 0}};
        CHECK(balls.candidates(all) == ~std::uint64_t(0) >> (BoundingSphereSet::most - count));
    }
}

TEST_CASE("balls: with NaN, huge or tiny numbers no shape is left out") {
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    const Real large = std::sqrt(std::numeric_limits<Real>::max()) * 2;
    const Real small = 1 / large;
    const BoundingSphere ball{.center = {0, 0, 0}, .radius = 1};
    const Vec3 beside(8, 0, 0);
    const Vec3 along(0, 0, 1);
    CHECK_FALSE(is_near({.origin = beside, .direction = along}, ball));
    for (const Real odd : {nan, infinity, large, small, Real(0)})
        CHECK(is_near({.origin = beside, .direction = odd * along}, ball));
    for (const Real odd : {nan, infinity, large})
        CHECK(is_near({.origin = odd * Vec3(1, 1, 1), .direction = along}, ball));
    for (const Real odd : {nan, infinity, large}) {
        CHECK(
            is_near({.origin = beside, .direction = along}, {.center = {0, 0, 0}, .radius = odd}));
        CHECK(
            is_near({.origin = beside, .direction = along}, {.center = {odd, 0, 0}, .radius = 1}));
    }
    CHECK(
        is_near({.origin = {small, 0, 0}, .direction = along}, {.center = {0, 0, 0}, .radius = 0}));
}

TEST_CASE("balls: no candidate is lost at any size") {
    CHECK(for_all(is_near_at_any_size, 100000));
}

TEMPLATE_TEST_CASE("balls: the nearest is the same in a list, in balls and in a hierarchy", "",
                   Sphere, Triangle, Square, Cylinder, Cone, OrientedBox) {
    CHECK(for_all(finds_the_same<TestType>, 300));
}

TEST_CASE("balls: few shapes are tested, unless balls are switched off") {
    PrimitiveList<Sphere> row;
    for (int i = 0; i < 5; ++i)
        row.push_back({.shape = {.center = {Real(i), 0, 0}, .radius = Real(0.25)}});
    const Ray ray{.origin = {3, 0, 5}, .direction = {0, 0, -1}};
    CHECK(nearest(row, ray).count == 5);
    row.build_acceleration();
    CHECK(nearest(row, ray).count == 1);
    CHECK(row.is_short_list());
    row.build_acceleration({.balls = false});
    CHECK(nearest(row, ray).count == 5);
    row.build_acceleration();
    row.push_back(row.front());  // not arranged any more
    CHECK(nearest(row, ray).count == 6);
}
