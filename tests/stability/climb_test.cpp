// A search for the largest errors of the references by hill climbing: from random rays and shapes,
// a few numbers are changed repeatedly, and changes that increase the error are kept
// (docs/reference/stability.md). The same search each time; RAYSTEPS_CLIMB=100 makes it a hundred
// times as long, and RAYSTEPS_SEED another one:
//   RAYSTEPS_CLIMB=100 RAYSTEPS_SEED=7 build/climb_test_double "*spheres*"
#include "tests/stability/judge.hpp"
#include "tests/stability/moves.hpp"
#include "tests/stability/promises.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/verdict.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace rt;

namespace {

enum class Goal { off, band, ulps };

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtoull(said, nullptr, 10);
}

/// The error of the answer, of which the caller knows an as large one already: then any smaller
/// number. Negative if there is no such error.
template <class Shape>
double error_of(const Case<Shape>& asked, Goal goal, double known) {
    const auto got = intersect(asked.ray, asked.shape, asked.interval);
    if (goal == Goal::off) return got ? off(asked, *got, known) : -1;
    const Judgment judgment = judged(asked, got);
    if (goal == Goal::ulps) return judgment.ulps.value_or(-1);
    if (asked.interval.min != 0 || !judgment.wrong || starts_on(asked)) return -1;
    return band(asked, got, std::max(known, 0.0));
}

template <class Shape>
struct Climb {
    Case<Shape> top;
    double height = -1;
};

/// Climbs from the case until no step of many is higher.
template <class Shape>
void climb(Random& random, Climb<Shape>& here, Goal goal, std::uint64_t& steps) {
    // A band is slow to find; and where no decision is wrong, another start is better.
    const int patience = goal == Goal::band ? 300 : 3000;
    for (int idle = 0; idle < (here.height < 0 ? 30 : patience) && steps > 0; ++idle, --steps) {
        Case<Shape> next = here.top;
        for (int i = random.below(3); i >= 0; --i) step(random, next);
        if (!is_ordinary(next)) continue;
        const double error = error_of(next, goal, here.height);
        // A band is at least the known one, where it is not examined.
        if (goal == Goal::band ? error <= here.height : error < here.height) continue;
        if (error > here.height) idle = 0;
        here = {.top = next, .height = error};
    }
}

template <class Shape>
Climb<Shape> highest(Goal goal, std::uint64_t steps) {
    const std::uint64_t seed = number_from("RAYSTEPS_SEED", 2021) * 1'000'000;
    Climb<Shape> best;
    for (std::uint64_t start = 0; steps > 0; ++start) {
        Random random(seed + start);
        Climb<Shape> here = best;
        if (best.height < 0 || start % 3 != 0) {
            here = {.top = start_of_climb<Shape>(random)};
        } else {  // again from the best so far, or near it
            for (int i = random.below(6); i > 0; --i) step(random, here.top);
        }
        here.height = is_ordinary(here.top) ? error_of(here.top, goal, -1) : -1;
        climb(random, here, goal, steps);
        if (here.height > best.height) best = here;
    }
    return best;
}

template <class Shape>
void hold(const char* shape, Goal goal, const char* measure, double promise) {
    const std::uint64_t once = goal == Goal::off ? 100'000 : goal == Goal::ulps ? 7'000 : 3'000;
    const std::uint64_t steps = once * number_from("RAYSTEPS_CLIMB", 1);
    const auto [top, height] = highest<Shape>(goal, steps);
    const auto got = intersect(top.ray, top.shape, top.interval);
    const std::string where =
        intersection_report(top.ray, top.shape, top.interval, got, exact_answer(top));
    std::printf("| %s | %s | %llu | %.2f | %.0f |\n", shape, measure,
                static_cast<unsigned long long>(steps), height, promise);
    if (number_from("RAYSTEPS_CLIMB", 1) > 1) std::printf("%s\n", where.c_str());
    std::fflush(stdout);
    CHECK(verdict(height <= promise, where));
}

template <class Shape>
void hold_promises(const char* shape) {
    constexpr Bars bars = promised<Shape>;
    if (bars.off < unbounded) hold<Shape>(shape, Goal::off, "off", bars.off);
    if (bars.band < unbounded) hold<Shape>(shape, Goal::band, "band", bars.band);
    if (bars.ulps < unbounded) hold<Shape>(shape, Goal::ulps, "ulp", bars.ulps);
}

}  // namespace

TEST_CASE("no climb exceeds what is promised for spheres") {
    hold_promises<Sphere>("sphere");
}

TEST_CASE("no climb exceeds what is promised for planes") {
    hold_promises<Plane>("plane");
}

TEST_CASE("no climb exceeds what is promised for triangles") {
    hold_promises<Triangle>("triangle");
}

TEST_CASE("no climb exceeds what is promised for squares") {
    hold_promises<Square>("square");
}

TEST_CASE("no climb exceeds what is promised for cylinders") {
    hold_promises<Cylinder>("cylinder");
}

TEST_CASE("no climb exceeds what is promised for cones") {
    hold_promises<Cone>("cone");
}

TEST_CASE("no climb exceeds what is promised for oriented boxes") {
    hold_promises<OrientedBox>("box");
}
