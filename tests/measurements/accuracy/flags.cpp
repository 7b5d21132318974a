// The references, compiled with the flags in RT_FLAGS: their time, their bits, and the promises of
// docs/reference/stability.md that they keep. Prints a row of CSV for each shape.
#include "tests/measurements/accuracy/flagged.hpp"
#include "tests/stability/judge.hpp"

#include "common/math/vector.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <limits>

using namespace rt;

namespace {

constexpr int rays_of_a_sweep = 1000;

template <class Shape>
std::vector<Case<Shape>> cases_of(int last_sweep, int of_each) {
    Random random(1);
    std::vector<Case<Shape>> cases;
    for (int sweep = 0; sweep <= last_sweep; ++sweep)
        for (int i = 0; i < of_each; ++i) draw(random, Sweep(sweep), cases.emplace_back());
    return cases;
}

template <class Shape>
double nanoseconds() {
    const auto cases = cases_of<Shape>(int(Sweep::moderate), 4096);
    double least = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 15; ++turn) {
        const std::clock_t start = std::clock();
        for (int pass = 0; pass < 16; ++pass) (void)answers(cases);
        least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return 1e9 * least / 16 / double(cases.size());
}

/// The rays, of a million at points of an edge that two triangles share, that pass between them.
int leaks() {
    Random random(2);
    std::vector<Case<Triangle>> cases;
    for (int i = 0; i < 1'000'000; ++i) {
        const Vec3 way = random.direction();
        const Vec3 side = unit(cross(way, random.direction()));
        const Vec3 a = random.point(1);
        const Vec3 b = a + random.direction();
        const Vec3 target = a + random.between(0, 1) * (b - a);
        const Vec3 across = unit(cross(b - a, way));
        const Vec3 c = target + across + random.between(-1, 1) * side;
        const Vec3 d = target - across + random.between(-1, 1) * side;
        const Vec3 origin = target - Real(3) * way;
        const Ray ray{.origin = origin, .direction = target - origin};
        cases.push_back({.ray = ray, .shape = {a, b, c}});
        cases.push_back({.ray = ray, .shape = {b, a, d}});
    }
    const auto got = answers(cases);
    int lost = 0;
    for (std::size_t i = 0; i < got.size(); i += 2) lost += !got[i] && !got[i + 1];
    return lost;
}

template <class Shape>
void measure(const char* shape) {
    const auto cases = cases_of<Shape>(int(Sweep::sliver), rays_of_a_sweep);
    const auto got = answers(cases);
    std::uint64_t bits = 0;
    int wrong = 0;
    double off = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        bits = 31 * bits + (got[i] ? std::bit_cast<std::uint64_t>(*got[i]) : 1);
        const Judgment judgment = judged(cases[i], got[i]);
        wrong += judgment.wrong;
        if (!judgment.wrong) off = std::max(off, judgment.off.value_or(0));
    }
    const int lost = std::is_same_v<Shape, Triangle> ? leaks() : 0;
    std::printf("%s,%s,%.2f,%d,%d,%.3g,%d,%016llx\n", RT_FLAGS, shape, nanoseconds<Shape>(),
                int(cases.size()), wrong, off, lost, static_cast<unsigned long long>(bits));
    std::fflush(stdout);
}

}  // namespace

int main() {
    std::puts("flags,shape,nanoseconds,rays,wrong,off,leaks,bits");
    measure<Sphere>("sphere");
    measure<Plane>("plane");
    measure<Triangle>("triangle");
}
