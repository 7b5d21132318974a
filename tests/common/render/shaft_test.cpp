// Shapes outside the shaft: no ray to any point of the light hits them.
#include "common/render/shaft.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/spots.hpp"

using namespace rt;

namespace {

/// The start of a shadow ray from the point.
template <class Shape>
Vec3 start_from(const Spot<Shape>& spot, Vec3 light) {
    const bool outside = dot(light - spot.point, spot.normal) > 0;
    const auto [point, error] = snapped_to(spot.shape, spot.point);
    const ShadingPoint surface{
        .point = point, .geometric_normal = outside ? spot.normal : -spot.normal, .error = error};
    return shadow_ray(surface, light).ray.origin;
}

/// The largest light, up to this one, whose shaft excludes the shape or the sphere, according to
/// the test.
template <class Held>
Light largest_beside(Vec3 point, Light light, const Held& what) {
    Real held = light.radius;
    light.radius = 0;
    for (int i = 0; i < 60; ++i) {
        const Real radius = (light.radius + held) / 2;
        Light tried = light;
        tried.radius = radius;
        if (Shaft(point, tried).may_intersect(what))
            held = radius;
        else
            light.radius = radius;
    }
    return light;
}

/// From the surface itself, or from somewhere else, towards a light that only just leaves it out.
template <class Shape>
Verdict is_left_alone(Random& random) {
    const Spot<Shape> spot = draw(random, Shape());
    const Light widest{.position = random.point(6), .radius = 6};
    const Vec3 point = random.coin() ? start_from(spot, widest.position) : random.point(6);
    Light light = largest_beside(point, widest, spot.shape);
    if constexpr (Bounded<Shape>)
        if (random.coin()) light = largest_beside(point, widest, bounding_sphere(spot.shape));
    if (light.radius == 0) return {};
    const Vec3 nearest = unit(spot.point - light.position);
    for (int i = 0; i < 100; ++i) {
        const Vec3 way = i % 2 == 0 ? random.direction() : unit(nearest + random.point(1));
        const Ray ray{.origin = point, .direction = light.position + light.radius * way - point};
        if (occludes(ray, spot.shape, {.min = 0, .max = 1}))
            return verdict(false, "the shaft does not contain " + code(spot.shape) +
                                      " or its bounding sphere, and " + code(ray) + " hits it");
    }
    return {};
}

/// Above a floor, below a ceiling.
const Light lamp{.position = {0, 2, 0}, .radius = Real(0.25)};
const Vec3 on_floor(1, 64 * unit_roundoff, 0);

}  // namespace

TEMPLATE_TEST_CASE("a shaft: no ray hits a shape outside it", "", Sphere, Plane, Triangle, Square,
                   Cylinder, Cone, OrientedBox) {
    CHECK(for_all(is_left_alone<TestType>, 10000));
}

TEST_CASE("a shaft: shapes beside or behind it are excluded") {
    const Shaft shaft(on_floor, lamp);
    CHECK(shaft.may_intersect(Sphere{.center = {Real(0.5), 1, 0}, .radius = Real(0.1)}));
    CHECK(shaft.may_intersect(Sphere{.center = {Real(0.5), 1, Real(0.2)}, .radius = Real(0.1)}));
    CHECK(shaft.may_intersect(Sphere{.center = lamp.position, .radius = 1}));  // a globe around it
    CHECK_FALSE(
        shaft.may_intersect(Sphere{.center = {Real(0.5), 1, Real(0.3)}, .radius = Real(0.1)}));
    CHECK_FALSE(shaft.may_intersect(Sphere{.center = {-1, 1, 0}, .radius = Real(0.9)}));
    CHECK_FALSE(shaft.may_intersect(Sphere{.center = {0, 4, 0}, .radius = 1}));
    CHECK_FALSE(shaft.may_intersect(Plane{.point = {0, 3, 0}}));
    CHECK_FALSE(shaft.may_intersect(Plane{.point = {0, -1, 0}, .normal = {0, -2, 0}}));
    CHECK_FALSE(shaft.may_intersect(Plane{.point = {3, 0, 0}, .normal = {1, 1, 0}}));
    CHECK(shaft.may_intersect(Plane{.point = {0, 1, 0}}));
    const Vec3 through_lamp(0, Real(2.2), 0);
    CHECK(shaft.may_intersect(Plane{.point = through_lamp}));
    const Real tiny = 1024 * std::numeric_limits<Real>::min();  // its square is 0
    for (const Real length : {tiny, 1 / tiny})
        CHECK(shaft.may_intersect(Plane{.point = through_lamp, .normal = {0, length, 0}}));
    CHECK_FALSE(
        shaft.may_intersect(Cylinder{.center = {2, 1, 0}, .radius = Real(0.5), .height = 2}));
    CHECK(shaft.may_intersect(Cylinder{.center = {Real(0.5), 1, 0}, .radius = Real(0.1)}));
}

TEST_CASE("a shaft: a ray that leaves a flat shape, or a sphere, does not hit it again") {
    const Shaft shaft(on_floor, lamp);
    CHECK_FALSE(shaft.may_intersect(Plane{}));
    CHECK_FALSE(shaft.may_intersect(Square{.basis = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, .side = 8}));
    CHECK_FALSE(shaft.may_intersect(Triangle{.a = {-2, 0, -2}, .b = {3, 0, -2}, .c = {1, 0, 2}}));
    CHECK_FALSE(shaft.may_intersect(Sphere{.center = {1, -1, 0}, .radius = 1}));
    CHECK(shaft.may_intersect(
        Sphere{.center = {2, 0, 0}, .radius = 1}));  // its horizon cuts the lamp
    const Shaft inside({1, -64 * unit_roundoff, 0}, lamp);
    CHECK(inside.may_intersect(Plane{}));
    CHECK(inside.may_intersect(Sphere{.center = {1, -1, 0}, .radius = 1}));
}

TEST_CASE("a shaft: inside the light, or with NaN, every shape is a candidate") {
    const Shaft within({0, Real(2.1), 0}, lamp);
    CHECK(within.may_intersect(Sphere{.center = lamp.position, .radius = 1}));
    CHECK(within.may_intersect(Plane{.point = lamp.position}));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (const Vec3& point : {Vec3(nan, 0, 0), Vec3(0, infinity, 0)}) {
        const Shaft shaft(point, lamp);
        CHECK(shaft.may_intersect(Sphere{}));
        CHECK(shaft.may_intersect(Plane{}));
        CHECK(shaft.may_intersect(Cone{}));
    }
}

TEST_CASE("suspects: the tested shapes block the same rays as all shapes") {
    CHECK(for_all([](Random& random) {
        Scene scene;
        const int count = 1 + random.below(4);
        for (int i = 0; i < count; ++i) {
            scene.spheres.push_back({.shape = draw(random, Sphere()).shape});
            scene.planes.push_back({.shape = draw(random, Plane()).shape});
            scene.squares.push_back({.shape = draw(random, Square()).shape});
            scene.cones.push_back({.shape = draw(random, Cone()).shape});
        }
        if (random.coin()) build_acceleration(scene);
        if (random.coin()) scene.spheres.build_acceleration({.hierarchy_from = 1});
        const Light light{.position = random.point(3), .radius = random.between(0, 1)};
        const Vec3 point = random.point(3);
        const Shaft shaft(point, light);
        PotentialOccluders occluders(shaft);
        visit_shapes(occluders, scene);
        Context context;
        for (int i = 0; i < 20; ++i) {
            const Vec3 aim = light.position + light.radius * random.direction();
            const Ray ray{.origin = point, .direction = aim - point};
            AnyHit of_all(ray, {.min = 0, .max = 1}, context);
            visit_shapes(of_all, scene);
            if (of_all.found() != occluders.block(ray, {.min = 0, .max = 1}, context))
                return verdict(false, code(ray) + " hits a shape that was excluded");
        }
        return Verdict();
    }));
}
