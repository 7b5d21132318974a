// The closest of two shapes less than 4 ulps apart: `--precision exact` is always right, and the
// references are not, which shows that the test is hard enough.
#include "tests/stability/orders.hpp"
#include "tests/stability/promises.hpp"
#include "tests/stability/sweeps.hpp"

#include "tests/kit/catch.hpp"

#include <cstdio>

using namespace rt;

namespace {

void hold(const char* what, const Orders& orders) {
    std::printf("| which is nearer | %s | %llu of %llu | |\n", what,
                static_cast<unsigned long long>(orders.wrong),
                static_cast<unsigned long long>(orders.asked));
    INFO(orders.where);
    if (are_certified())
        CHECK(orders.wrong == 0);
    else
        CHECK(orders.wrong > 0);
}

}  // namespace

TEST_CASE("of shapes that are a few ulps apart the nearest is hit") {
    hold("near ties", orders_of_near_ties(number_from("RAYSTEPS_STABILITY", 1)));
}

TEST_CASE("of shapes that are equally near the first is hit") {
    const Orders orders = orders_of_ties();
    CHECK(orders.asked == 3 * (14 * 14 + 6 * 6));
    hold("ties", orders);
}
