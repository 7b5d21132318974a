// Stage 10, the shadow ray, against CR §3.2, its constants put right.
#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step10_shadows/shadows.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/shape_checks.hpp"

#include <cmath>

using namespace rt;

namespace {

/// A point of the floor, seen from above, with the error of a point near 1.
const ShadingPoint on_floor{.point = {0, 0, 0},
                            .normal = {0, 1, 0},
                            .geometric_normal = {0, 1, 0},
                            .to_eye = {0, 1, 0},
                            .error = 16 * unit_roundoff};

std::string call(const ShadingPoint& surface, Vec3 light) {
    return "shadow_ray(" + code(surface) + ", " + code(light) + ")";
}

std::string ray_report(const ShadingPoint& surface, Vec3 light, const ShadowRay& way) {
    return call(surface, light) + "\n  got:      " + code(way.ray) + ", " + code(way.interval);
}

/// Tests that the shape is hit on the way or not, as expected, and that the shadow ray is valid.
template <class Shape>
Verdict occluded(const ShadingPoint& surface, Vec3 light, const Shape& shape, bool expected) {
    const ShadowRay way = shadow_ray(surface, light);
    const std::optional<Real> t = intersect(way.ray, shape, way.interval);
    const std::string name = expected ? "in_the_way" : "not_in_the_way";
    const bool is_way = way.interval.min < way.interval.max && way.ray.direction != Vec3(0);
    return verdict(is_way && t.has_value() == expected, [&] {
        return ray_report(surface, light, way) + "\n  which has " + got_text(t) + " with " +
               code(shape) + "\n  expected: " +
               (expected ? "a hit" : "no hit, min < max, and a direction that is not zero") +
               "\n  paste:    CHECK(" + name + "(" + code(surface) + ", Vec3" + code(light) + ", " +
               code(shape) + "));";
    });
}

/// The shape throws its shadow on the surface.
template <class Shape>
Verdict in_the_way(const ShadingPoint& surface, Vec3 light, const Shape& shape) {
    return occluded(surface, light, shape, true);
}

/// It does not.
template <class Shape>
Verdict not_in_the_way(const ShadingPoint& surface, Vec3 light, const Shape& shape) {
    return occluded(surface, light, shape, false);
}

/// The points at both ends of the interval are the surface's and the light's, within a hundredth of
/// the distance.
Verdict leads_there(const ShadingPoint& surface, Vec3 light) {
    const auto [ray, interval] = shadow_ray(surface, light);
    const Vec3 begin = at(ray, interval.min);
    const Vec3 end = at(ray, interval.max);
    const Real slack = distance(surface.point, light) / 100;
    return verdict(distance(begin, surface.point) <= slack && distance(end, light) <= slack,
                   ray_report(surface, light, {ray, interval}) + "\n  which is  from " +
                       text(begin) + " to " + text(end) + "\n  expected: from " +
                       text(surface.point) + " to " + text(light));
}

/// The surface of the shape at `aim`, as seen from `eye`.
template <class Shape>
std::optional<ShadingPoint> seen(Vec3 eye, Vec3 aim, const Shape& shape) {
    const Ray ray{.origin = eye, .direction = aim - eye};
    Context context;
    ClosestHit closest(ray, context);
    const PrimitiveList<Shape> primitives{{.shape = shape, .material = {}}};
    closest.test(primitives);
    const std::optional<Hit> hit = closest.hit();
    if (!hit) return std::nullopt;
    return shading_point(*hit, ray);
}

/// The light at `light` reaches the point at `aim`, seen from `eye`, past its own shape.
template <class Shape>
Verdict no_acne(Vec3 eye, Vec3 aim, Vec3 light, const Shape& shape) {
    const std::optional<ShadingPoint> surface = seen(eye, aim, shape);
    if (!surface) return {};  // rounded past it
    return not_in_the_way(*surface, light, shape);
}

constexpr Real scales[] = {Real(1e-6), Real(1e-3), 1, Real(1e3), Real(1e6)};

/// A surface through the origin with a point that is off it, by almost its error.
struct OffSurface {
    ShadingPoint surface;
    Plane plane;
};

/// Large errors reveal more about a formula than small ones.
OffSurface draw_off_surface(Random& random, Real depth) {
    ShadingPoint surface = draw_surface(random, Vec3(0));
    surface.error = random.between(Real(0.001), Real(0.003));
    surface.point = -depth * surface.error * surface.geometric_normal;
    return {.surface = surface, .plane = {.point = Vec3(0), .normal = surface.geometric_normal}};
}

/// A unit direction that leaves the surface, by no less than the cosine.
Vec3 draw_leaving(Random& random, Vec3 side, Real least_cosine) {
    const Real cosine = random.between(least_cosine, 1);
    const Vec3 v = random.direction();
    const Vec3 aside = std::abs(dot(v, side)) < Real(0.9) ? v : Vec3(v.y, v.z, v.x);
    const Vec3 across = cross(side, aside);
    if (across == Vec3(0)) return side;
    return cosine * side + std::sqrt(1 - cosine * cosine) * unit(across);
}

/// Seen and lit from the side of the normal at `aim`; the shape's size equals its distance from the
/// origin.
template <class Shape>
Verdict no_acne_from_outside(Random& random, const Shape& shape, Vec3 aim, Vec3 normal) {
    const Real size = length(aim);
    const Real eye_distance = size * random.between(1, 100);
    const Vec3 eye = aim + eye_distance * draw_leaving(random, normal, Real(0.1));
    const Real light_distance = size * random.between(1, 8);
    return no_acne(eye, aim, aim + light_distance * draw_leaving(random, normal, Real(0.01)),
                   shape);
}

/// A lamp in a square around the center shines on the surface behind it.
Verdict lamp_is_not_shadowed(Random& random, Vec3 center, const Basis& basis, Vec3 way) {
    const Square lamp_in{.center = center, .basis = basis, .side = 2};
    const Vec3 across = random.between(Real(-0.9), Real(0.9)) * basis.x +
                        random.between(Real(-0.9), Real(0.9)) * basis.y;
    const Vec3 light = snapped_to(lamp_in, center + across).point;
    ShadingPoint surface = draw_surface(random, light - way);
    if (dot(surface.geometric_normal, way) < 0) {
        surface.normal = -surface.normal;
        surface.geometric_normal = -surface.geometric_normal;
    }
    return not_in_the_way(surface, light, lamp_in);
}

/// The ray starts above the flat face, by the error or a little more, wherever the light is.
Verdict starts_off(const ShadingPoint& surface, Vec3 light) {
    const ShadowRay way = shadow_ray(surface, light);
    const Vec3 away = way.ray.origin - surface.point;
    const Real above = dot(away, surface.geometric_normal);
    return verdict(
        above >= Real(0.9999) * surface.error && length(away) <= 10 * surface.error, [&] {
            return ray_report(surface, light, way) + "\n  which starts " + text(above) +
                   " above the face\n  expected: above by surface.error = " + text(surface.error) +
                   " or a little more";
        });
}

/// True if a light above the flat face is seen from the surface, which lies on a plane.
Verdict sees_a_light_above(Random& random, const ShadingPoint& surface, const Plane& plane) {
    const Vec3 way = draw_leaving(random, surface.geometric_normal, Real(0.02));
    return not_in_the_way(surface, random.between(1, 8) * way, plane);
}

}  // namespace

TEST_CASE("the way leads from the point to the light (CR §3.2)", "[part shadow_ray][3 points]") {
    CHECK(leads_there(on_floor, Vec3(0, 4, 0)));
    CHECK(leads_there(on_floor, Vec3(3, Real(0.5), -4)));
    CHECK(for_all([](Random& random) {
        const ShadingPoint surface = draw_surface(random, random.point(3));
        const Real far = random.between(Real(0.5), 64);
        return leads_there(
            surface,
            surface.point + far * draw_leaving(random, surface.geometric_normal, Real(0.1)));
    }));
}

TEST_CASE("a shape between the point and the light casts a shadow (CR §3.2)") {
    const Sphere ball{.center = {0, 2, 0}, .radius = 1};
    CHECK(in_the_way(on_floor, Vec3(0, 4, 0), ball));
    CHECK(in_the_way(on_floor, Vec3(0, Real(3.25), 0), ball));
    CHECK(in_the_way(on_floor, Vec3(1, 64, 0), ball));
    const Square wall{.center = {3, 2, 0}, .basis = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, .side = 1};
    CHECK(in_the_way(on_floor, Vec3(6, 4, 0), wall));
    CHECK(not_in_the_way(on_floor, Vec3(4, 1, 0), ball));
    CHECK(for_all([](Random& random) {
        const ShadingPoint surface = draw_surface(random, random.point(3));
        const Real far = random.between(Real(0.5), 64);
        const Vec3 way = far * draw_leaving(random, surface.geometric_normal, Real(0.1));
        const Real share = random.between(Real(0.1), Real(0.95));
        const Sphere ball_on_it{.center = surface.point + share * way,
                                .radius = random.between(Real(0.01), Real(0.04)) * far};
        return in_the_way(surface, surface.point + way, ball_on_it);
    }));
}

TEST_CASE("a shape behind the light casts no shadow (CR §3.2, maxDist)") {
    CHECK(not_in_the_way(on_floor, Vec3(0, 4, 0), Sphere{.center = {0, 6, 0}, .radius = 1}));
    CHECK(
        not_in_the_way(on_floor, Vec3(0, Real(0.5), 0), Sphere{.center = {0, 2, 0}, .radius = 1}));
    CHECK(for_all([](Random& random) {
        const ShadingPoint surface = draw_surface(random, random.point(3));
        const Real far = random.between(Real(0.5), 64);
        const Vec3 way = far * draw_leaving(random, surface.geometric_normal, Real(0.1));
        const Real share = random.between(Real(1.05), 8);
        const Sphere ball{.center = surface.point + share * way,
                          .radius = random.between(Real(0.01), Real(0.04)) * far};
        return not_in_the_way(surface, surface.point + way, ball);
    }));
}

TEST_CASE("a shape behind the point casts no shadow (PHY, t positive)") {
    CHECK(not_in_the_way(on_floor, Vec3(0, 4, 0), Sphere{.center = {0, -2, 0}, .radius = 1}));
    CHECK(for_all([](Random& random) {
        const ShadingPoint surface = draw_surface(random, random.point(3));
        const Real far = random.between(Real(0.5), 64);
        const Vec3 way = far * draw_leaving(random, surface.geometric_normal, Real(0.1));
        const Sphere ball{.center = surface.point - random.between(Real(0.05), 4) * way,
                          .radius = random.between(Real(0.01), Real(0.04)) * far};
        return not_in_the_way(surface, surface.point + way, ball);
    }));
}

TEST_CASE("a lamp in the plane of the ceiling lights the room (CR §2.4, §3.2)") {
    const Square ceiling{
        .center = {0, 1, 0}, .basis = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, .side = 2};
    CHECK(not_in_the_way(on_floor, Vec3(0, 1, 0), ceiling));
    CHECK(not_in_the_way(on_floor, Vec3(Real(0.3), 1, Real(-0.7)), ceiling));
    CHECK(for_all([](Random& random) {
        const Basis basis = random.basis();
        const Vec3 way = random.between(Real(0.5), 4) * draw_leaving(random, basis.z, Real(0.5));
        return lamp_is_not_shadowed(random, random.point(3), basis, way);
    }));
    CHECK(for_all([](Random& random) {
        // Near the world's origin, where the light's own coordinates do not reveal its distance
        // from the surface, nor the rounding there.
        const Basis basis = random.basis();
        const Vec3 way = random.between(100, 1000) * draw_leaving(random, basis.z, Real(0.5));
        return lamp_is_not_shadowed(random, random.point(1), basis, way);
    }));
    CHECK(for_all([](Random& random) {
        // And far from it, where neither the surface's coordinates nor its error reveal how the
        // light's are rounded.
        const Basis basis = random.basis();
        const Vec3 way = random.between(100, 1000) * draw_leaving(random, basis.z, Real(0.5));
        return lamp_is_not_shadowed(random, way + random.point(1), basis, way);
    }));
}

TEST_CASE(
    "shadow rays from surfaces of any scale to a light that they do not occlude (CR §3.2, erratum "
    "31)") {
    constexpr int cases = 2000;
    CHECK(for_all(
        [](Random& random) {
            const Real scale = scales[random.below(5)];
            const Sphere sphere{.center = scale * random.point(1), .radius = scale};
            const Vec3 normal = random.direction();
            return no_acne_from_outside(random, sphere, sphere.center + scale * normal, normal);
        },
        cases));
    CHECK(for_all(
        [](Random& random) {
            const Real scale = scales[random.below(5)];
            const Sphere sphere{.center = scale * random.point(1), .radius = scale};
            const Vec3 aim = sphere.center + scale * random.direction();
            const Real from_center = scale * Real(0.9);
            const Vec3 eye = sphere.center + random.between(0, from_center) * random.direction();
            const Vec3 light = sphere.center + random.between(0, from_center) * random.direction();
            return no_acne(eye, aim, light, sphere);
        },
        cases));
    CHECK(for_all(
        [](Random& random) {
            const Real scale = scales[random.below(5)];
            const auto [x, y, z] = random.basis();
            const Plane plane{.point = scale * random.point(1), .normal = z};
            const Vec3 aim = plane.point + scale * random.between(-8, 8) * x;
            return no_acne_from_outside(random, plane, aim, z);
        },
        cases));
    CHECK(for_all(
        [](Random& random) {
            const Real scale = scales[random.below(5)];
            const auto [x, y, z] = random.basis();
            const Cylinder cylinder{
                .center = scale * random.point(1), .axis = z, .radius = scale, .height = 4 * scale};
            const Vec3 aim = cylinder.center + scale * (x + random.between(-1, 1) * z);
            return no_acne_from_outside(random, cylinder, aim, x);
        },
        cases));
}

TEST_CASE("an open tube casts a shadow on its inside (CR §3.2)") {
    const Cylinder tube{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 4};
    const std::optional<ShadingPoint> wall = seen(Vec3(0), Vec3(1, 0, 0), tube);
    REQUIRE(wall);
    CHECK(in_the_way(*wall, Vec3(-4, 1, 0), tube));
    CHECK(not_in_the_way(*wall, Vec3(-2, 9, 0), tube));  // in by the open top
    CHECK(not_in_the_way(*wall, Vec3(Real(-0.5), 1, 0), tube));
    CHECK(for_all([](Random& random) {
        const auto [x, y, z] = random.basis();
        const Real size = random.between(Real(0.5), 2);
        const Cylinder cylinder{
            .center = random.point(3), .axis = z, .radius = size, .height = 4 * size};
        const std::optional<ShadingPoint> side =
            seen(cylinder.center, cylinder.center + size * x, cylinder);
        if (!side) return Verdict{};  // rounded past it
        if (random.coin()) {
            const Vec3 beyond = random.between(-4, -2) * x + random.between(-2, 2) * z;
            return in_the_way(*side, cylinder.center + size * beyond, cylinder);
        }
        const Vec3 within = random.between(Real(-0.9), Real(0.5)) * x + random.between(-1, 1) * z;
        return not_in_the_way(*side, cylinder.center + size * within, cylinder);
    }));
}

TEST_CASE("a point that is off its surface by its error still sees the light (contract)") {
    CHECK(for_all(
        [](Random& random) {
            const auto [surface, plane] = draw_off_surface(random, Real(0.98));
            return sees_a_light_above(random, surface, plane);
        },
        2000));
}

TEST_CASE("shadow rays from points with an interpolated normal (CR §6)") {
    CHECK(for_all(
        [](Random& random) {
            auto [surface, plane] = draw_off_surface(random, Real(0.98));
            surface.normal = draw_leaving(random, surface.geometric_normal, Real(0.2));
            return sees_a_light_above(random, surface, plane);
        },
        2000));
    CHECK(for_all([](Random& random) {
        auto [surface, plane] = draw_off_surface(random, Real(0.98));
        surface.normal = draw_leaving(random, surface.geometric_normal, Real(0.99));
        return starts_off(surface, random.between(1, 8) * random.direction());
    }));
}

TEST_CASE("a shape close to the surface casts a shadow at any scale (CR §3.2, erratum 31)") {
    CHECK(for_all(
        [](Random& random) {
            const Real scale = scales[random.below(5)];
            ShadingPoint surface = draw_surface(random, scale * random.point(1));
            surface.error = 16 * unit_roundoff * scale;
            const Vec3 way = draw_leaving(random, surface.geometric_normal, Real(0.1));
            const Real gap = scale * std::pow(Real(10), random.between(-5, -2));
            const Sphere ball{.center = surface.point + Real(1.5) * gap * way, .radius = gap / 2};
            return in_the_way(surface, surface.point + scale * random.between(1, 8) * way, ball);
        },
        2000));
}

TEST_CASE("a shape close to the light casts a shadow at any scale (CR §3.2, erratum 31)") {
    CHECK(for_all([](Random& random) {
        // From 0.9995 of the way to the light: no right answer ends before it.
        const Real scale = scales[random.below(5)];
        ShadingPoint surface = draw_surface(random, scale * random.point(1));
        surface.error = 16 * unit_roundoff * scale;
        const Real far = scale * random.between(1, 8);
        const Vec3 way = far * draw_leaving(random, surface.geometric_normal, Real(0.1));
        const Sphere ball{.center = surface.point + Real(0.9997) * way,
                          .radius = Real(0.0002) * far};
        return in_the_way(surface, surface.point + way, ball);
    }));
}

TEST_CASE("a plane ten errors above the surface casts a shadow (contract)") {
    CHECK(for_all([](Random& random) {
        const auto [surface, plane] = draw_off_surface(random, 0);
        const Vec3 way = draw_leaving(random, surface.geometric_normal, Real(0.1));
        const Plane above{.point = 10 * surface.error * surface.geometric_normal,
                          .normal = surface.geometric_normal};
        return in_the_way(surface, random.between(1, 8) * way, above);
    }));
}

TEST_CASE("a plane ten errors above the surface casts a shadow, for lights far away (contract)") {
    CHECK(for_all([](Random& random) {
        auto [surface, plane] = draw_off_surface(random, 0);
        if (random.coin()) surface.error *= sizeof(Real) == sizeof(float) ? Real(0x1p-16) : hair;
        const Plane above{.point = 10 * surface.error * surface.geometric_normal,
                          .normal = surface.geometric_normal};
        return in_the_way(surface, random.between(100, 1000) * surface.geometric_normal, above);
    }));
}
