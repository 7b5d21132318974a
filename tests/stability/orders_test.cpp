// The closest of two shapes less than 4 ulps apart: `--precision exact` is always right, and the
// references are not, which shows that the test is hard enough.
#include "tests/stability/orders.hpp"

#include "tests/kit/catch.hpp"

#include <cstdio>
#include <cstdlib>

using namespace rt;

namespace {

void hold(const char* what, const Orders& orders) {
    std::printf("| which is nearer | %s | %llu of %llu | |\n", what,
                static_cast<unsigned long long>(orders.wrong),
                static_cast<unsigned long long>(orders.asked));
    INFO(orders.where);
    if (asks_exactly())
        CHECK(orders.wrong == 0);
    else
        CHECK(orders.wrong > 0);
}

}  // namespace

TEST_CASE("of shapes that are a few ulps apart the nearest is hit") {
    const char* times = std::getenv("RAYSTEPS_STABILITY");
    hold("near ties",
         orders_of_near_ties(times == nullptr ? 1 : std::strtoull(times, nullptr, 10)));
}

TEST_CASE("of shapes that are equally near the first is hit") {
    const Orders orders = orders_of_ties();
    CHECK(orders.asked == 3 * (14 * 14 + 6 * 6));
    hold("ties", orders);
}
