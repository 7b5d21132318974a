// The certified kernels of `--precision exact` in the sweeps of the stability suite: no wrong
// decision, and t within certified_ulps. docs/reference/stability.md. RAYSTEPS_STABILITY=10 tests
// ten times as many rays.
#include "tests/stability/certified.hpp"
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
