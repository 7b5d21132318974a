// The references at the extremes, and in exact_test the certified kernels of `--precision exact`,
// against exact arithmetic: docs/reference/stability.md. Prints its measurements.
// RAYSTEPS_STABILITY=10 tests ten times as many rays.
#include "tests/stability/judge.hpp"
#include "tests/stability/promises.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace rt;

namespace {

/// One measure over a sweep, and where it was worst.
struct Measure {
    std::vector<double> values;
    double worst = 0;
    std::string where;

    void add(double value, const std::function<std::string()>& place) {
        values.push_back(value);
        if (!(value > worst)) return;
        worst = value;
        where = place();
    }

    [[nodiscard]] double typical() {
        if (values.empty()) return 0;
        const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
        std::ranges::nth_element(values, middle);
        return *middle;
    }
};

struct Row {
    std::uint64_t rays = 0;
    std::uint64_t wrong = 0;
    Measure off;
    Measure band;
    Measure end;  ///< the backward error at an end of the interval
    Measure ulps;
};

/// `at_end`: an end of the interval is as near to the hit as its rounding.
template <class Shape>
void measure(Row& row, const Case<Shape>& asked, bool at_end, std::optional<Real> got,
             const std::string& drawn) {
    const Judgment judgment = judged(asked, got);
    const auto place = [&] {
        return intersection_report(asked.ray, asked.shape, asked.interval, got,
                                   exact_answer(asked)) +
               drawn;
    };
    if (judgment.off) row.off.add(*judgment.off, place);
    if (judgment.ulps) row.ulps.add(*judgment.ulps, place);
    if (!judgment.wrong) return;
    ++row.wrong;
    Measure& band_of_kind = at_end || starts_on(asked) ? row.end : row.band;
    band_of_kind.add(band(asked, got, band_of_kind.worst), place);
}

/// So far that a difference from the origin may drop all digits of a point of the shape.
void go_farther(Random& random, Ray& ray) {
    ray.origin -= std::pow(Real(10), random.between(8, 18)) * ray.direction;
}

/// Returns whether a ray of the sweep is tested again in an interval around its hit. From the
/// surface, 0 is such an end already, and a ray has one move to excuse both.
bool is_tested_again(Sweep sweep, std::uint64_t ray) {
    return are_certified() || (sweep != Sweep::surface && sweep != Sweep::mixed && ray % 4 == 0);
}

template <class Shape>
Row measured(Sweep sweep) {
    const std::uint64_t seed = number_from("RAYSTEPS_SEED", 2021);
    const std::uint64_t rays = 2'000 * number_from("RAYSTEPS_STABILITY", 1);
    Row row;
    for (std::uint64_t i = 0; i < rays; ++i) {
        Random random(seed + i);
        Case<Shape> asked;
        draw(random, sweep, asked);
        if (are_certified() && sweep == Sweep::distance && random.coin())
            go_farther(random, asked.ray);
        const std::string drawn =
            "\n  random:   RAYSTEPS_SEED=" + std::to_string(seed) + ", ray " + std::to_string(i);
        for (int question = 0; question < 2; ++question) {
            const auto got = intersect(asked.ray, asked.shape, asked.interval);
            const bool at_end = question > 0 || sweep == Sweep::surface;
            measure(row, asked, at_end, got, drawn);
            ++row.rays;
            if (!got || !is_tested_again(sweep, i)) break;
            asked.interval = around(random, *got);
        }
    }
    return row;
}

Verdict within(const Measure& measure, double bar, const std::string& what) {
    return verdict(measure.worst <= bar, what + " " + std::to_string(measure.worst) + ", and " +
                                             std::to_string(bar) + " at most:\n" + measure.where);
}

}  // namespace

TEMPLATE_TEST_CASE("shapes at the extremes", "", Sphere, Plane, Triangle, Square, Cylinder, Cone,
                   OrientedBox) {
    if (are_certified() && std::is_same_v<TestType, OrientedBox>) return;
    const Bars bars = bars_of<TestType>();
    // A t that is as far off as promised may be on the wrong side; a plane's off has no bound.
    const double end = are_certified() ? 0 : std::isfinite(bars.off) ? bars.off : 8;
    std::vector<Sweep> sweeps = sweeps_of<TestType>();
    if (are_certified()) sweeps.push_back(Sweep::range);
    for (const Sweep sweep : sweeps) {
        Row row = measured<TestType>(sweep);
        std::printf("| %s | %s | %.2f | %.2f | %.2f | %.2f | %.2g | %.2g | %.0f |\n",
                    kind_of<TestType>().c_str(), name(sweep).c_str(), row.off.typical(),
                    row.off.worst, row.band.worst, row.end.worst, row.ulps.typical(),
                    row.ulps.worst, 1e6 * double(row.wrong) / double(row.rays));
        std::fflush(stdout);
        CHECK(within(row.off, bars.off, name(sweep) + ": off the surface, in u L:"));
        CHECK(within(row.band, bars.band, name(sweep) + ": the ray must be moved, in u L:"));
        CHECK(within(row.end, end,
                     name(sweep) + ": beside an end of the interval, the ray must be moved:"));
        CHECK(within(row.ulps, bars.ulps, name(sweep) + ": ulps of t:"));
    }
}

TEST_CASE("a sphere's roots from its surface, along it, are no quotients of rounding errors") {
    // Two regressions, one in double and one in float: the reported root was some three diameters
    // away, for a ray that leaves the sphere immediately.
    for (const Case<Sphere>& asked :
         {Case<Sphere>{.ray = {{-0x1.e3835af034669p-1, 0x1.8e13a0e03dcd2p+0, 0x1.5c158074e38fep+0},
                               {0x1.ba6e0559201b6p-2, 0x1.74f86a2303436p-3, -0x1.c7e8d51139bc8p-2}},
         .shape = {{-0x1.0f313511e4f45p+0, -0x1.2b40ee71562a6p-2, 0x1.f859d402c391p-2},
                   Real(0x1.059df421f262bp+1)}},
          Case<Sphere>{.ray = {{-0x1.9dd5p+0, 0x1.21caf4p-3, -0x1.2852cap+0},
                               {0x1.62a892p-4, -0x1.5c125cp-1, 0x1.635abap-1}},
          .shape = {{-0x1.051318p+0, 0x1.3733cap-2, -0x1.12a802p+0}, Real(0x1.3f9494p-1)}}}) {
        Row row;
        measure(row, asked, true, intersect(asked.ray, asked.shape, asked.interval), "");
        CHECK(within(row.off, 8, "off the surface, in u L:"));
        CHECK(within(row.end, 8, "the ray must be moved, in u L:"));
    }
}

TEST_CASE("a ray from the surface of a cylinder or a cone hits only its other side") {
    // Points of whole numbers are exactly on these: one root is 0, and no rounding error beside it.
    Random random(1);
    const std::vector<Vec3> places = {{3, 0, 4}, {-5, 0, 0}, {4, 0, -3}, {0, 0, 5}};
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 place = places[std::size_t(random.below(int(places.size())))];
        const Vec3 foot = random.point_in_eighths(8);
        const Ray ray{.origin = foot + place, .direction = random.direction()};
        const Real outward = dot(ray.direction, place);

        const Cylinder cylinder{
            .center = foot, .axis = {0, 1, 0}, .radius = 5, .height = Real(1e6)};
        const std::optional<Real> t = intersect(ray, cylinder, {});
        const Vec3 across(ray.direction.x, 0, ray.direction.z);
        const Real chord = -2 * outward / dot(across, across);
        CHECK(t.has_value() == (outward < 0 && chord * std::abs(ray.direction.y) < Real(4e5)));
        if (t) CHECK(*t == Approx(chord).epsilon(1e-4).margin(1e-3));

        const Cone cone{
            .apex = foot - Vec3(0, 5, 0), .axis = {0, 1, 0}, .radius = 10, .height = 10};
        const std::optional<Real> on_cone = intersect(ray, cone, {});
        const Real inward = ray.direction.y - outward / 5;  // by the cone's normal
        if (inward <= 0) CHECK_FALSE(on_cone);
        if (on_cone) CHECK(*on_cone > inward);
    }
}

TEST_CASE("a ray that starts much nearer than a square's side is long, as in no sweep") {
    const Case<Square> near{
        .ray = {{Real(-1.4350641164736544), Real(-4.343630180230489), Real(5.530113892749623)},
                {Real(0.21327073823827608), Real(-0.8606788088733925), Real(-1.11573869331664)}},
        .shape = {.center = {Real(-1.2673453783347006), Real(0.872453267459969),
                             Real(1.0753605853295594)},
                  .basis = {.x = {Real(-0.30512078431300416), Real(0.5628449375958693),
                                  Real(-0.768184146675079)},
                            .y = {Real(-0.7599171604360033), Real(-0.6300685068234888),
                                  Real(-0.15981109468400773)},
                            .z = {Real(-0.5739575038755909), Real(0.534994628881376),
                                  Real(0.6199625237165388)}},
                  .side = Real(12.58092200582979)}};
    Row row;
    measure(row, near, false, intersect(near.ray, near.shape, near.interval), "");
    CHECK(within(row.band, 3, "the ray must be moved, in u L:"));
}

TEST_CASE("a ray parallel to a square up to rounding, and beside it, misses") {
    // Regressions in float and in double. The slope of these rays is a rounding error, and so was
    // the place at which they were found to hit.
    for (const Case<Square>& asked :
         {Case<Square>{.ray = {{Real(-0.7450942), Real(-0.75072116), Real(0.9123897)},
                               {Real(-0.28841847), Real(-1.0586598), Real(-0.26668078)}},
         .shape = {.center = {Real(-0.8365996), Real(-0.9385979), Real(0.8490405)},
                  .basis = {.x = {Real(0.32828814), Real(-0.94456285), Real(-0.005290754)},
                           .y = {Real(-0.8708075), Real(-0.30047455), Real(-0.38911355)},
                           .z = {Real(0.36595243), Real(0.1323486), Real(-0.9211746)}},
                  .side = Real(0.9361457)}},
          Case<Square>{
              .ray = {{Real(2.216121335060054), Real(1.2359799646178717),
                       Real(-1.1984848410391067)},
                      {Real(-0.40372145367427503), Real(-1.039160912318061),
                       Real(0.7967689836973868)}},
 .shape = {
     .center = {Real(1.9697909566377185), Real(0.8322286481762196), Real(-0.9576852759720311)},
    .basis = {.x = {Real(0.8703206408589381), Real(0.20966206599061893), Real(0.4456274230558894)},
             .y = {Real(0.16056665424499142), Real(0.7346109365129174), Real(-0.6592155349354137)},
             .z = {Real(-0.4655752695745949), Real(0.6452817911890586), Real(0.6056823245897007)}},
    .side = Real(2.613751006120166)}}}) {
        Row row;
        measure(row, asked, true, intersect(asked.ray, asked.shape, asked.interval), "");
        CHECK(within(row.off, 6, "off the surface, in u L:"));
        CHECK(within(row.end, 6, "the ray must be moved, in u L:"));
    }
}

namespace {

/// A ray of whole numbers in the plane of a rim of an upright shape, at this height.
Ray in_plane_of_rim(Random& random, int height) {
    const auto whole = [&](int most) { return Real(random.below(2 * most + 1) - most); };
    const Real x = whole(12);
    const Real z = whole(12);
    return {.origin = {x, Real(height), z}, .direction = {whole(3), 0, Real(random.below(3) + 1)}};
}

template <class Shape>
void check_near_side(const Case<Shape>& asked) {
    const auto got = intersect(asked.ray, asked.shape, asked.interval);
    INFO(intersection_report(asked.ray, asked.shape, asked.interval, got, exact_answer(asked)));
    CHECK_FALSE((got && judged(asked, got).wrong));
}

}  // namespace

TEST_CASE("a ray in the plane of a rim never hits the far side of it in place of the near one") {
    // The two roots were decided by two roundings. By hand for the first: (14 - 3 t)² + (t - 3)² =
    // 25, so t is 3 or 6, and both points are on the rim.
    const Cone cone{.apex = {0, -3, 3}, .axis = {-1, 0, 0}, .radius = 5, .height = 5};
    const Ray along_rim{.origin = {-5, 11, 0}, .direction = {0, -3, 1}};
    if (const auto t = intersect(along_rim, cone, {})) CHECK(*t == Approx(3));
    Random random(1);
    for (int i = 0; i < 1'000; ++i) {
        const int height = 1 + random.below(8);
        const Real radius = Real(1 + random.below(8));
        const Ray ray = in_plane_of_rim(random, height);
        check_near_side(Case<Cone>{
            .ray = ray,
            .shape = {
                .apex = {0, 0, 0}, .axis = {0, 1, 0}, .radius = radius, .height = Real(height)}});
        check_near_side(Case<Cylinder>{.ray = ray,
                                       .shape = {.center = {0, 0, 0},
                                                 .axis = {0, 1, 0},
                                                 .radius = radius,
                                                 .height = Real(2 * height)}});
    }
}

TEST_CASE("a ray in the plane of a rim, for an axis in any direction") {
    // The rise of these rays is a rounding error, whose sign decides which root is within.
    Random random(2);
    Row cones;
    Row cylinders;
    for (int i = 0; i < 200; ++i) {
        const Vec3 axis = random.direction();
        const Real height = std::ldexp(Real(1), -random.below(12));
        const auto rim = [&] { return unit(cross(axis, random.direction())); };
        const Vec3 from = height * axis + rim();
        const Vec3 d = height * axis + rim() - from;
        const Ray ray{.origin = from - random.between(0, 4) * d, .direction = d};
        const Case<Cone> on_cone{.ray = ray, .shape = {{0, 0, 0}, axis, 1, height}};
        const Case<Cylinder> on_cylinder{.ray = ray, .shape = {{0, 0, 0}, axis, 1, 2 * height}};
        measure(cones, on_cone, false, intersect(ray, on_cone.shape, {}), "");
        measure(cylinders, on_cylinder, false, intersect(ray, on_cylinder.shape, {}), "");
    }
    CHECK(within(cones.band, promised<Cone>.band, "the ray must be moved, in u L:"));
    CHECK(within(cylinders.band, promised<Cylinder>.band, "the ray must be moved, in u L:"));
}

TEST_CASE("a band is found though a little more is wrong again") {
    // The near root of this ray is 4096 u below the rim, and the far one 16 u lower: the far one is
    // the first hit only of rays that are moved up by more than 4096 u, and less than 4112 u.
    const Real u = unit_roundoff;
    const Case<Cylinder> asked{
        .ray = {{-3, 1 - 4080 * u, 0}, {1, -8 * u, 0}},
        .shape = {.center = {0, 0, 0}, .axis = {0, 1, 0}, .radius = 1, .height = 2}};
    const double moved = 4096 / 3.0;  // L is 3
    CHECK(band(asked, Real(4), 0) >= moved * 0.99);
    CHECK(band(asked, Real(4), 0) <= moved * 1.14);  // a step of the search
}

TEST_CASE("a direction as short or as long as the range allows hits a sphere and a cylinder") {
    // (r / |d|)², which leaves the range of float, is not needed.
    const Real shortest = sizeof(Real) == 4 ? Real(0x1p-60) : Real(0x1p-500);
    for (const Real speed : {shortest, 1 / shortest})
        for (const Real radius : {Real(0x1p-15), Real(20), Real(0x1p30)}) {
            const Ray ray{.origin = {0, 0, 2 * radius}, .direction = {0, 0, -speed}};
            CHECK(hits(ray, Sphere{.center = {0, 0, 0}, .radius = radius}, radius / speed));
            CHECK(hits(ray, Cylinder{{0, 0, 0}, {0, 1, 0}, radius, radius}, radius / speed));
        }
}

TEST_CASE("a ray through a cone's apex from behind hits it, though rounding is behind it") {
    // Regressions, one in float and one in double: no move of these rays makes a miss right.
    for (const Case<Cone>& asked :
         {Case<Cone>{.ray = {{0, 64, 64}, {0, -3, -3}},
         .shape = {.apex = {0, 0, 0},
                  .axis = {Real(0.5576413), Real(0.8294655), Real(-0.031985793)},
                  .radius = 1,
                  .height = Real(0.49239776)}},
          Case<Cone>{.ray = {{-213, -344, -321}, {3, -3, 0}},
          .shape = {.apex = {-211, -346, -321},
                   .axis = {Real(-0.60528370003728238), Real(0.75259427512344357),
                            Real(0.25929423348889991)},
                   .radius = 1,
                   .height = Real(2.9228329068881247)}}}) {
        Row row;
        measure(row, asked, false, intersect(asked.ray, asked.shape, asked.interval), "");
        CHECK(within(row.off, 8, "off the surface, in u L:"));
        CHECK(within(row.band, 2, "the ray must be moved, in u L:"));
    }
}
