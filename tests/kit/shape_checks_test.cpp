// The draws of the suites.
#include "tests/kit/shape_checks.hpp"
#include "tests/kit/catch.hpp"

using namespace rt;

TEST_CASE("A reduced case of a cone ends where its only direction is along the side") {
    // ½ is the choice of a reduced case, and makes the direction z. Lines along y and z are on this
    // cone's side, and the ray comes to the one along y from the side of its normal, −z.
    const Cone cone{.apex = Vec3(0), .axis = unit(Vec3(0, 1, 1)), .radius = 1, .height = 1};
    Random plainest(std::vector<double>{});
    const auto aimed = aimed_from_outside(
        Sample<Cone>{.shape = cone, .point = {0, Real(0.5), 0}, .normal = {0, 0, -1}}, plainest);
    CHECK(aimed.ray.origin == Vec3(0, Real(0.5), Real(-2.25)));  // halfway between 0.5 and 4 away
    CHECK(aimed.ray.direction == Vec3(0, 0, Real(2.25) / Real(2.125)));
}
