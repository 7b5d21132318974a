// The share of a light beside a plane, with which stage 11's suite computes what it expects.
#include "tests/suites/step11_soft_shadows/share_of_light.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

TEST_CASE("the share of a cone beside a plane is integrated to 1e-6") {
    // The piece of a cap that a great circle cuts off, by Girard's theorem.
    for (const double half_angle : {0.01, 0.5, 1.0, 1.5})
        for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999}) {
            const double offset = part * half_angle;
            const double piece =
                2 * std::acos(std::sin(offset) / std::sin(half_angle)) -
                2 * std::cos(half_angle) * std::acos(std::tan(offset) / std::tan(half_angle));
            const double share = piece / (2 * exact_pi * (1 - std::cos(half_angle)));
            CHECK(std::abs(share_beside_plane(-offset, half_angle) - share) < 1e-6);
            CHECK(std::abs(share_beside_plane(offset, half_angle) - (1 - share)) < 1e-6);
        }
}
