// Work that is shared among threads.
#include "common/system/parallel_for.hpp"

#include "tests/kit/catch.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace rt;

TEST_CASE("in parallel: each piece is done once") {
    for (const int threads : {1, 2, 7}) {
        std::vector<int> times(1000);
        parallel_for(threads, times.size(), nullptr, [&](std::size_t i) { ++times[i]; });
        CHECK(std::ranges::count(times, 1) == 1000);
    }
    parallel_for(3, 0, nullptr, [](std::size_t) { FAIL("no work was expected"); });
}

TEST_CASE("in parallel: no piece is begun once it is to stop") {
    std::atomic<bool> stop = false;
    std::atomic<int> done = 0;
    parallel_for(2, 1'000'000, &stop, [&](std::size_t i) {
        if (i == 10) stop = true;
        ++done;
    });
    CHECK(done >= 11);
    CHECK(done < 1'000'000);
    parallel_for(2, 10, &stop, [](std::size_t) { FAIL("the work was stopped"); });
}

TEST_CASE("in parallel: an exception of a piece is rethrown after the others have ended") {
    for (const int threads : {1, 4}) {
        std::atomic<int> at_work = 0;
        const auto work = [&](std::size_t i) {
            if (i == 5) throw std::runtime_error("the sixth");
            ++at_work;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            --at_work;
        };
        CHECK_THROWS_WITH(parallel_for(threads, 100, nullptr, work), "the sixth");
        CHECK(at_work == 0);
    }
}
