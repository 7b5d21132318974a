// Stage 14, against geometry.
#include "steps/step14_torus/torus.hpp"

#include "tests/kit/picture.hpp"
#include "tests/kit/shape_checks.hpp"

using namespace rt;

namespace {

/// From 1.5 to 2.5 of its center.
const Torus lying{.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 2, .tube = Real(0.5)};

/// On the outer half, which lies behind its tangent planes.
Sample<Torus> draw(Random& random) {
    const Basis basis = draw_basis(random);
    const Torus torus{.center = random.point(3),
                      .axis = basis.z,
                      .radius = random.between(1, 2),
                      .tube = random.between(Real(0.25), Real(0.75))};
    const Real angle = random.between(Real(-1.4), Real(1.4));
    const Vec3 normal = std::cos(angle) * basis.x + std::sin(angle) * basis.z;
    return {.shape = torus,
            .point = torus.center + torus.radius * basis.x + torus.tube * normal,
            .normal = normal};
}

}  // namespace

TEST_CASE("a ray along a diameter hits four times, nearest first (geometry)",
          "[part intersect][2 points]") {
    CHECK(hits(Ray{.origin = {-5, 0, 0}, .direction = {1, 0, 0}}, lying, Real(2.5)));
    CHECK(hits(Ray{.origin = {-2, 0, 0}, .direction = {1, 0, 0}}, lying, Real(0.5)));
    CHECK(hits(Ray{.origin = {0, 0, 0}, .direction = {1, 0, 0}}, lying, Real(1.5)));
    CHECK(hits(Ray{.origin = {2, 0, 0}, .direction = {Real(0.5), 0, 0}}, lying, 1));
    CHECK(misses(Ray{.origin = {3, 0, 0}, .direction = {1, 0, 0}}, lying));
}

TEST_CASE("a ray through the hole, or over the tube, is a miss (geometry)") {
    CHECK(misses(Ray{.origin = {0, 5, 0}, .direction = {0, -1, 0}}, lying));
    CHECK(misses(Ray{.origin = {1, 5, 1}, .direction = {0, -1, 0}}, lying));
    CHECK(misses(Ray{.origin = {-5, Real(0.6), 0}, .direction = {1, 0, 0}}, lying));
    CHECK(hits(Ray{.origin = {0, 5, 2}, .direction = {0, -1, 0}}, lying, Real(4.5)));
}

TEST_CASE("rays aimed at the outer half hit, at any length of the direction (geometry)",
          "[2 points]") {
    CHECK(aimed_rays_hit(draw));
}

TEST_CASE("a torus behind the origin is a miss (PHY, t positive)") {
    CHECK(nothing_behind_is_hit(draw));
}

TEST_CASE("hits count strictly inside the interval (contract)") {
    CHECK(interval_is_kept(draw));
}

TEST_CASE("a hit moves with the ray and the torus (geometry)") {
    CHECK(motion_changes_nothing(draw));
}

TEST_CASE("normals point away from the circle in the tube (geometry)", "[part normal]") {
    CHECK(normals_point_outward(draw));
    CHECK(normal_is(lying, Vec3(Real(1.5), 0, 0), Vec3(-1, 0, 0)));
}

TEST_CASE("a ray or torus with NaN is a miss (contract)", "[part intersect]") {
    CHECK(nan_misses(draw));
}
