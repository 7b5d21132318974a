// The certified kernels of `--precision exact` in the sweeps of the stability suite: not one wrong
// decision, and t within 8 ulp. docs/stability.md. RAYSTEPS_STABILITY=10 asks ten times as many
// rays.
#include "tests/oracle/inputs.hpp"
#include "tests/stability/sweeps.hpp"

#include "steps/step03_sphere/sphere.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step06_square/square.hpp"
#include "steps/step07_cylinder/cylinder.hpp"
#include "steps/step08_cone/cone.hpp"

#include "tests/kit/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

using namespace rt;

namespace {

constexpr double bar = 8;  // ulps of t

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtoull(said, nullptr, 10);
}

/// The t within so many ulps of an exact one.
double ulps_between(Real came, const oracle::Number& expected) {
    const auto nearest = expected.convert_to<Real>();
    const Real ulp = std::nextafter(std::abs(nearest), infinity) - std::abs(nearest);
    return abs((oracle::Number(came) - expected) / oracle::Number(ulp)).convert_to<double>();
}

template <class Shape>
std::optional<oracle::Number> exact_t(const Case<Shape>& asked, Interval interval) {
    const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(interval));
    if (!root) return std::nullopt;
    return root->value();
}

/// How far the answer is from the exact one: infinitely, if one of them is a miss.
template <class Shape>
double ulps_off(const Case<Shape>& asked, Interval interval, std::optional<Real> came) {
    const auto expected = exact_t(asked, interval);
    if (came.has_value() != expected.has_value()) return double(infinity);
    return came ? ulps_between(*came, *expected) : 0;
}

/// An interval that ends or begins a few ulps from there, where a decision is hardest.
Interval around(Random& random, Real t) {
    const Real end = t * (1 + Real(random.below(33) - 16) * unit_roundoff);
    if (random.coin()) return {.min = end};
    return {.max = end};
}

/// So far that all digits of a point of the shape may be among those that a difference from the
/// origin drops.
void go_farther(Random& random, Ray& ray) {
    ray.origin -= std::pow(Real(10), random.between(8, 18)) * ray.direction;
}

struct Worst {
    double ulps = 0;
    std::uint64_t wrong = 0;
    std::string where;

    void add(double off, const std::string& place) {
        if (off > ulps && off < double(infinity)) ulps = off;
        if (off > bar && where.empty()) where = place;
        if (off > 1e6) ++wrong;  // another root, or none
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
            const auto came = intersect(asked.ray, asked.shape, interval);
            const double off = ulps_off(asked, interval, came);
            worst.add(off, off <= bar ? ""
                                      : told(asked.ray, asked.shape, interval, came, std::nullopt) +
                                            "\n  ulps off: " + std::to_string(off) +
                                            "\n  random:   ray " + std::to_string(i));
            if (!came) break;
            interval = around(random, *came);
        }
    }
    return worst;
}

template <class Shape>
void hold(const char* shape, std::initializer_list<Sweep> sweeps) {
    const std::uint64_t rays = 8'000 * number_from("RAYSTEPS_STABILITY", 1);
    for (const Sweep sweep : sweeps) {
        const Worst worst = measured<Shape>(sweep, rays);
        std::printf("| %s | %s | %llu | %.2f |\n", shape, name(sweep).c_str(),
                    static_cast<unsigned long long>(worst.wrong), worst.ulps);
        std::fflush(stdout);
        INFO(worst.where);
        CHECK(worst.wrong == 0);
        CHECK(worst.ulps <= bar);
    }
}

}  // namespace

TEST_CASE("spheres are decided as exact arithmetic does, t within 8 ulp") {
    hold<Sphere>("sphere", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                            Sweep::scale, Sweep::speed});
}

TEST_CASE("planes are decided as exact arithmetic does, t within 8 ulp") {
    hold<Plane>("plane", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                          Sweep::scale, Sweep::speed});
}

TEST_CASE("triangles are decided as exact arithmetic does, t within 8 ulp") {
    hold<Triangle>("triangle",
                   {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset, Sweep::scale,
                    Sweep::speed, Sweep::border, Sweep::point, Sweep::sliver});
}

TEST_CASE("squares are decided as exact arithmetic does, t within 8 ulp") {
    hold<Square>("square", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                            Sweep::scale, Sweep::speed, Sweep::border, Sweep::point});
}

TEST_CASE("cylinders are decided as exact arithmetic does, t within 8 ulp") {
    hold<Cylinder>("cylinder", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                                Sweep::scale, Sweep::speed, Sweep::border, Sweep::parallel});
}

TEST_CASE("cones are decided as exact arithmetic does, t within 8 ulp") {
    hold<Cone>("cone", {Sweep::moderate, Sweep::distance, Sweep::grazing, Sweep::offset,
                        Sweep::scale, Sweep::speed, Sweep::border, Sweep::point, Sweep::parallel});
}
