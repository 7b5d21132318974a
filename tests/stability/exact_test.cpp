// The certified kernels of `--precision exact` in the sweeps of the stability suite: no wrong
// decision, and t within certified_ulps. docs/reference/stability.md. RAYSTEPS_STABILITY=10 tests
// ten times as many rays.
#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/kit/verdict.hpp"
#include "tests/oracle/inputs.hpp"
#include "tests/stability/sweeps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <string>

using namespace rt;

namespace {

// A certified kernel's answer against the exact one.

/// The largest distance from the exact t, in ulps, found by a search that maximizes the error
/// (below); the proved bounds of the kernels are larger
/// (docs/reference/stability.md).
constexpr double certified_ulps = 11;

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtoull(said, nullptr, 10);
}

/// The distance from the exact t in ulps.
double ulps_between(Real got, const oracle::Number& expected) {
    const auto nearest = expected.convert_to<Real>();
    const Real ulp = std::nextafter(std::abs(nearest), infinity) - std::abs(nearest);
    return abs((oracle::Number(got) - expected) / oracle::Number(ulp)).convert_to<double>();
}

template <class Shape>
std::optional<oracle::Number> exact_t(const Case<Shape>& asked, Interval interval) {
    const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(interval));
    if (!root) return std::nullopt;
    return root->value();
}

/// The distance of the answer from the exact one: infinite if one of them is a miss.
template <class Shape>
double ulps_off(const Case<Shape>& asked, Interval interval, std::optional<Real> got) {
    const auto expected = exact_t(asked, interval);
    if (got.has_value() != expected.has_value()) return double(infinity);
    return got ? ulps_between(*got, *expected) : 0;
}

/// So far that a difference from the origin may drop all digits of a point of the shape.
void go_farther(Random& random, Ray& ray) {
    ray.origin -= std::pow(Real(10), random.between(8, 18)) * ray.direction;
}

struct Worst {
    double ulps = 0;
    std::uint64_t wrong = 0;
    std::string where;

    void add(double off, const std::string& place) {
        if (off > ulps && off < double(infinity)) ulps = off;
        if (off > certified_ulps && where.empty()) where = place;
        if (off > 1e6) ++wrong;  // another root, or a miss
    }
};

template <class Shape>
Worst measured(Sweep sweep, std::uint64_t rays) {
    const std::uint64_t seed = number_from("RAYSTEPS_SEED", 2021);
    Worst worst;
    for (std::uint64_t i = 0; i < rays; ++i) {
        Random random(seed + i);
        Case<Shape> asked;
        draw(random, sweep, asked);
        if (sweep == Sweep::distance && random.coin()) go_farther(random, asked.ray);
        Interval interval;
        for (int question = 0; question < 2; ++question) {
            const auto got = intersect(asked.ray, asked.shape, interval);
            const double off = ulps_off(asked, interval, got);
            worst.add(off, off <= certified_ulps
                               ? ""
                               : intersection_report(asked.ray, asked.shape, interval, got,
                                                     std::nullopt) +
                                     "\n  ulps off: " + std::to_string(off) + "\n  random:   ray " +
                                     std::to_string(i));
            if (!got) break;
            interval = around(random, *got);
        }
    }
    return worst;
}

template <class Shape>
void hold(const char* shape, std::initializer_list<Sweep> sweeps) {
    const std::uint64_t rays = 2'000 * number_from("RAYSTEPS_STABILITY", 1);
    for (const Sweep sweep : sweeps) {
        const Worst worst = measured<Shape>(sweep, rays);
        std::printf("| %s | %s | %llu | %.2f |\n", shape, name(sweep).c_str(),
                    static_cast<unsigned long long>(worst.wrong), worst.ulps);
        std::fflush(stdout);
        INFO(worst.where);
        CHECK(worst.wrong == 0);
        CHECK(worst.ulps <= certified_ulps);
    }
}

}  // namespace

TEST_CASE("spheres are decided as exact arithmetic does, t to a few ulps") {
    hold<Sphere>("sphere", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                            Sweep::scale, Sweep::speed, Sweep::surface, Sweep::range});
}

TEST_CASE("planes are decided as exact arithmetic does, t to a few ulps") {
    hold<Plane>("plane", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                          Sweep::scale, Sweep::speed, Sweep::surface, Sweep::range});
}

TEST_CASE("triangles are decided as exact arithmetic does, t to a few ulps") {
    hold<Triangle>("triangle", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                                Sweep::scale, Sweep::speed, Sweep::border, Sweep::point,
                                Sweep::sliver, Sweep::surface, Sweep::range});
}

TEST_CASE("squares are decided as exact arithmetic does, t to a few ulps") {
    hold<Square>("square",
                 {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset, Sweep::scale,
                  Sweep::speed, Sweep::border, Sweep::point, Sweep::surface, Sweep::range});
}

TEST_CASE("cylinders are decided as exact arithmetic does, t to a few ulps") {
    hold<Cylinder>("cylinder",
                   {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset, Sweep::scale,
                    Sweep::speed, Sweep::border, Sweep::parallel, Sweep::surface, Sweep::range});
}

TEST_CASE("cones are decided as exact arithmetic does, t to a few ulps") {
    hold<Cone>("cone", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                        Sweep::scale, Sweep::speed, Sweep::border, Sweep::point, Sweep::parallel,
                        Sweep::surface, Sweep::range});
}

// A search for the largest errors of the certified kernels: starting from random rays and shapes, a
// few numbers are changed repeatedly, and changes that increase t's error are kept. The same search
// each time; RAYSTEPS_STABILITY=100 makes a hundred times as many.

namespace {

void visit_numbers(Vec3& v, auto visit) {
    for (glm::length_t i = 0; i < 3; ++i) visit(v[i]);
}

// The numbers that may be changed: bases and axes keep their unit length.

void visit_numbers(Sphere& sphere, auto visit) {
    visit_numbers(sphere.center, visit);
    visit(sphere.radius);
}

void visit_numbers(Plane& plane, auto visit) {
    visit_numbers(plane.point, visit);
    visit_numbers(plane.normal, visit);
}

void visit_numbers(Triangle& triangle, auto visit) {
    for (Vec3* corner : {&triangle.a, &triangle.b, &triangle.c}) visit_numbers(*corner, visit);
}

void visit_numbers(Square& square, auto visit) {
    visit_numbers(square.center, visit);
    visit(square.side);
}

void visit_numbers(Cylinder& cylinder, auto visit) {
    visit_numbers(cylinder.center, visit);
    visit(cylinder.radius);
    visit(cylinder.height);
}

void visit_numbers(Cone& cone, auto visit) {
    visit_numbers(cone.apex, visit);
    visit(cone.radius);
    visit(cone.height);
}

/// A few of the numbers, by anything from a quarter to their last digit.
template <class Shape>
Case<Shape> changed(Random& random, Case<Shape> asked) {
    const int one_in = 1 + random.below(12);
    const auto change = [&](Real& number) {
        if (random.below(one_in) == 0)
            number *= 1 + std::ldexp(random.between(-1, 1), -random.below(53) - 2);
    };
    visit_numbers(asked.ray.origin, change);
    visit_numbers(asked.ray.direction, change);
    visit_numbers(asked.shape, change);
    return asked;
}

template <class Shape>
double ulps_off(const Case<Shape>& asked) {
    return ulps_off(asked, {}, intersect(asked.ray, asked.shape, {}));
}

template <class Shape>
void measure_ladder(const char* shape) {
    constexpr int steps = 300;
    const std::uint64_t climbs = 10 * number_from("RAYSTEPS_STABILITY", 1);
    double worst = 0;
    std::string where;
    for (std::uint64_t i = 0; i < climbs; ++i) {
        Random random(number_from("RAYSTEPS_SEED", 2021) + i);
        const std::array sweeps = {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                                   Sweep::speed};
        Case<Shape> best;
        draw(random, sweeps[i % sweeps.size()], best);
        double height = ulps_off(best);
        for (int step = 0; step < steps; ++step) {
            const Case<Shape> next = changed(random, best);
            const double off = ulps_off(next);
            if (off < height) continue;
            height = off;
            best = next;
        }
        if (height <= worst) continue;
        worst = height;
        where = intersection_report(best.ray, best.shape, {}, intersect(best.ray, best.shape, {}),
                                    std::nullopt);
    }
    std::printf("| %s | climbs | %llu | %.2f |\n", shape,
                static_cast<unsigned long long>(climbs * steps), worst);
    std::fflush(stdout);
    INFO(where);
    CHECK(worst <= certified_ulps);
}

}  // namespace

TEST_CASE("no search makes a certified t wrong by more than a few ulps") {
    measure_ladder<Sphere>("sphere");
    measure_ladder<Plane>("plane");
    measure_ladder<Triangle>("triangle");
    measure_ladder<Square>("square");
    measure_ladder<Cylinder>("cylinder");
    measure_ladder<Cone>("cone");
}

TEST_CASE("the largest known errors of certified t, and cases with underflowing products") {
    const auto check = [](const auto& asked, double bound) {
        const auto got = intersect(asked.ray, asked.shape, {});
        INFO(intersection_report(asked.ray, asked.shape, {}, got, std::nullopt));
        CHECK(ulps_off(asked, {}, got) <= bound);
    };
    check(
        Case<Triangle>{
            .ray = {{-0x1.01b98db21589p-357, -0x1.783616e0e613bp-358, -0x1.6816765d5121ep-356},
                    {0x1.bf1c59322491bp-2, 0x1.3852ee8a38e67p-1, 0x1.195c0bea21e14p+0}},
            .shape = {{-0x1.50eed9eedc3a4p-360, 0x1.c0566a6ec7352p-359, -0x1.5dae57bef7523p-359},
                      {-0x1.0d52290e6b118p-358, 0x1.083ff73198901p-358, -0x1.03717969e72acp-357},
                      {-0x1.0a033cdf5ab27p-366, 0x1.114d339923b31p-358, -0x1.200a87fee4b6dp-357}}},
        1);
    check(
        Case<Plane>{
            .ray = {{0x1.017260cbed26dp+3, 0x1.1f914d2adfcb4p+1, -0x1.69bbcf24bbac7p-1},
                    {-0x1.243cd6eafc6ebp+2, -0x1.a63a0ac1dd444p-2, 0x1.5f766130f1095p-2}},
            .shape = {{-0x1.4eea54da2b55ep-3, -0x1.f2d1e5cb183c6p+0, 0x1.c0081247a7483p-3},
                      {0x1.07cc556c3c5c5p-1, -0x1.9eabab6ad3e38p-1, -0x1.d4b02740df06ap-3}}},
        certified_ulps);
    check(
        Case<Sphere>{
            .ray = {{-0x1.bfa161a866657p+46, -0x1.278ff715717a7p+48, -0x1.a7a397e6200c3p+48},
                    {-0x1.001442fbef3b3p-5, 0x1.2470a25c70b5fp-1, 0x1.a917c66f676f7p-1}},
            .shape = {{0x1.f81f288684e6p+44, -0x1.25dcece53ff6cp+43, -0x1.57ea7dc217eb1p+44},
                      0x1.3e9eb7cbc8ed6p+47}},
        certified_ulps);
    check(
        Case<Cone>{
            .ray = {{-0x1.2ef0ec51990d9p+19, -0x1.2b810f487a29ep+23, -0x1.1ec60777bf855p+20},
                    {-0x1.96dffdd592c86p+37, -0x1.7e01abc57b226p+38, 0x1.d399d04b11083p+33}},
            .shape = {{-0x1.7c46c54afff45p+20, -0x1.b3193a8e864c4p+24, -0x1.5f40bd1ee5bd6p+19},
                      {0x1.ee6e8e4e92138p-1, 0x1.4f1187eaa769ap-3, 0x1.9d12117e09b7bp-3},
                      0x1.dfa38d211bbf1p+23,
                      0x1.454f7fe736cbap+0}},
        certified_ulps);
}
