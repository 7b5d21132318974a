// A search for the largest errors of the references by hill climbing: from random rays and shapes,
// a few numbers are changed repeatedly, and changes that increase the error are kept
// (docs/reference/stability.md). The same search each time; RAYSTEPS_CLIMB=100 makes it a hundred
// times as long, and RAYSTEPS_SEED another one:
//   RAYSTEPS_CLIMB=100 RAYSTEPS_SEED=7 build/climb_test_double "*Sphere"
#include "common/math/vector.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/kit/verdict.hpp"
#include "tests/stability/judge.hpp"
#include "tests/stability/promises.hpp"
#include "tests/stability/sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace rt;

namespace {

// The starts and the steps of a hill climb: cases of every kind, and small changes of them.

/// The numbers of a shape. All may be changed, except that axes stay unit vectors.
struct Parts {
    std::vector<Vec3*> points;
    std::vector<Vec3*> axes;
    std::vector<Real*> sizes;
};

Parts parts_of(Sphere& s) {
    return {{&s.center}, {}, {&s.radius}};
}

Parts parts_of(Plane& p) {
    return {{&p.point, &p.normal}, {}, {}};
}

Parts parts_of(Triangle& t) {
    return {{&t.a, &t.b, &t.c}, {}, {}};
}

Parts parts_of(Square& s) {
    return {{&s.center}, {&s.basis.x, &s.basis.y, &s.basis.z}, {&s.side}};
}

Parts parts_of(Cylinder& c) {
    return {{&c.center}, {&c.axis}, {&c.radius, &c.height}};
}

Parts parts_of(Cone& c) {
    return {{&c.apex}, {&c.axis}, {&c.radius, &c.height}};
}

Parts parts_of(OrientedBox& b) {
    Vec3& half = b.half_size;
    return {{&b.center}, {&b.basis.x, &b.basis.y, &b.basis.z}, {&half.x, &half.y, &half.z}};
}

/// The points of the case, with the ray's origin and direction.
template <class Shape>
std::vector<Vec3*> vectors_of(Case<Shape>& asked) {
    std::vector<Vec3*> all = parts_of(asked.shape).points;
    all.insert(all.end(), {&asked.ray.origin, &asked.ray.direction});
    return all;
}

/// Returns whether the vectors are of unit length and at right angles, each scalar product within 2
/// u: so an axis is a unit vector within 1 u.
bool are_orthonormal(const std::vector<Vec3*>& axes) {
    using Wide = glm::vec<3, long double>;
    for (const Vec3* a : axes)
        for (const Vec3* b : axes)
            if (std::abs(dot(Wide(*a), Wide(*b)) - (a == b ? 1 : 0)) > 2 * unit_roundoff)
                return false;
    return true;
}

/// Returns whether the errors are promised: the largest coordinate and the length of the direction
/// are from 2^-20 to 2^20, of certified kernels 2^-60 to 2^60, and no size is less than 2^-30 of
/// the largest coordinate.
template <class Shape>
bool is_ordinary(Case<Shape> asked) {
    const auto [points, axes, sizes] = parts_of(asked.shape);
    Real largest = largest_component(asked.ray.origin);
    for (const Vec3* point : points) largest = std::max(largest, largest_component(*point));
    for (const Real* size : sizes) largest = std::max(largest, *size);
    const int most = are_certified() ? 60 : 20;
    const auto good = [&](Real x) { return std::isnormal(x) && std::abs(std::ilogb(x)) <= most; };
    return good(length(asked.ray.direction)) && good(largest) && are_orthonormal(axes) &&
           std::ranges::all_of(sizes,
                               [&](const Real* size) { return *size >= std::ldexp(largest, -30); });
}

/// A vector along an axis of the world, or in a plane of two.
Vec3 flattened(Random& random, Vec3 v) {
    const int kept = 1 + random.below(6);  // a bit for each coordinate
    return {kept & 1 ? v.x : 0, kept & 2 ? v.y : 0, kept & 4 ? v.z : 0};
}

/// The case in whole numbers, in powers of two, or parallel to axes of the world.
template <class Shape>
void simplify(Random& random, Case<Shape>& asked) {
    const int way = random.below(3);
    const auto power = [](Real x) {
        return x == 0 ? x : std::copysign(power_of_two_below(std::abs(x)), x);
    };
    for (Vec3* v : vectors_of(asked)) {
        if (way == 0) *v = round(Real(4) * *v);
        if (way == 1) *v = {power(v->x), power(v->y), power(v->z)};
    }
    const auto [points, axes, sizes] = parts_of(asked.shape);
    for (Real* size : sizes) *size = way == 0 ? std::max(std::round(*size), Real(1)) : power(*size);
    if (way == 2) asked.ray.direction = flattened(random, asked.ray.direction);
    if (axes.empty() || random.coin()) return;
    const Basis basis = random.axes();
    if (axes.size() == 3) std::tie(*axes[0], *axes[1]) = std::tie(basis.x, basis.y);
    *axes.back() = basis.z;
}

/// The ray through two points of the rim of a cylinder or a cone.
template <class Shape>
void aim_along_rim(Random& random, Case<Shape>& asked) {
    const auto [points, axes, sizes] = parts_of(asked.shape);
    const Vec3& axis = *axes[0];
    const Real height = *sizes[1] / (std::is_same_v<Shape, Cone> ? 1 : 2);
    const auto rim = [&] {
        return *points[0] + height * axis + *sizes[0] * unit(cross(axis, random.direction()));
    };
    const Vec3 from = rim();
    asked.ray = {.origin = from, .direction = rim() - from};
    asked.ray.origin = at(asked.ray, -random.between(0, 4));
}

/// A case of a sweep, of ordinary sizes or simplified.
template <class Shape>
Case<Shape> start_of_climb(Random& random) {
    Case<Shape> asked;
    draw(random, Sweep(random.below(int(Sweep::mixed) + 1)), asked);
    if constexpr (requires { asked.shape.one_sided; }) asked.shape.one_sided = false;
    if (random.below(3) == 0) simplify(random, asked);
    if (parts_of(asked.shape).axes.size() == 1 && random.below(4) == 0)
        aim_along_rim(random, asked);
    return asked;
}

/// 2^-3 to 2^3, of either sign.
Real any_power(Random& random) {
    return std::ldexp(Real(random.coin() ? 1 : -1), random.below(7) - 3);
}

/// Up to 1, and any magnitude down to the last digit.
Real any_fraction(Random& random) {
    return std::ldexp(random.between(-1, 1), -random.below(53));
}

/// Changes a few of the numbers that are no axis: by an ulp, by a fraction, or by a factor.
void change_numbers(Random& random, const std::vector<Real*>& all) {
    const int way = random.below(3);
    for (int i = random.below(way == 2 ? 1 : 4); i >= 0; --i) {
        Real& x = *all[std::size_t(random.below(int(all.size())))];
        if (way == 0 && x != 0) x = std::nextafter(x, random.coin() ? infinity : -infinity);
        if (way == 1) x *= 1 + any_fraction(random) / 2;
        if (way == 2)
            x *= random.coin() ? any_power(random) : Real(random.below(3)) * any_fraction(random);
    }
}

void turn_axes(Random& random, const std::vector<Vec3*>& axes) {
    Vec3& z = *axes.back();
    z = unit(z + any_fraction(random) * random.direction());
    if (axes.size() == 1) return;
    *axes[0] = unit(cross(*axes[1], z));
    *axes[1] = cross(z, *axes[0]);
}

/// Changes the whole case: coordinates exchanged, the direction's length, the start of the ray, the
/// place and the size of everything, or the root that is looked for.
template <class Shape>
void change_whole(Random& random, Case<Shape>& asked) {
    auto& [ray, shape, interval] = asked;
    const auto [points, axes, sizes] = parts_of(shape);
    const int way = random.below(5);
    if (way == 0) {
        const int i = random.below(3);
        const int j = random.below(3);
        for (Vec3* v : axes) std::swap((*v)[i], (*v)[j]);
        for (Vec3* v : vectors_of(asked)) std::swap((*v)[i], (*v)[j]);
    } else if (way == 1) {
        ray.direction *= random.coin() ? any_power(random) : random.between(Real(0.5), 2);
    } else if (way == 2) {
        const Real t = intersect(ray, shape, interval).value_or(1);
        ray.origin = at(ray, t * any_fraction(random));
    } else if (way == 3) {
        const Vec3 by = largest_component(ray.origin) * any_fraction(random) * random.direction();
        const Real scale = random.coin() ? std::abs(any_power(random)) : Real(1);
        for (Vec3* v : vectors_of(asked))
            if (v != &ray.direction) *v = scale == 1 ? *v + by : scale * *v;
        for (Real* size : sizes) *size *= scale;
    } else {
        interval.min = 0;
        if (random.coin()) interval.min = intersect(ray, shape, {}).value_or(0) * Real(1.001);
    }
}

/// One small change.
template <class Shape>
void step(Random& random, Case<Shape>& asked) {
    const Parts parts = parts_of(asked.shape);
    const int way = random.below(14);
    if (way < 8) {
        std::vector<Real*> all = parts.sizes;
        for (Vec3* v : vectors_of(asked)) all.insert(all.end(), {&v->x, &v->y, &v->z});
        change_numbers(random, all);
    } else if (way == 8 && !parts.axes.empty()) {
        turn_axes(random, parts.axes);
    } else {
        change_whole(random, asked);
    }
}

enum class Goal { off, band, ulps };

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
void hold(Goal goal, const char* measure, double promise) {
    const std::uint64_t once = goal == Goal::off ? 100'000 : goal == Goal::ulps ? 7'000 : 3'000;
    const std::uint64_t steps = once * number_from("RAYSTEPS_CLIMB", 1);
    const auto [top, height] = highest<Shape>(goal, steps);
    const auto got = intersect(top.ray, top.shape, top.interval);
    const std::string where =
        intersection_report(top.ray, top.shape, top.interval, got, exact_answer(top));
    std::printf("| %s | %s | %llu | %.2f | %.0f |\n", kind_of<Shape>().c_str(), measure,
                static_cast<unsigned long long>(steps), height, promise);
    if (number_from("RAYSTEPS_CLIMB", 1) > 1) std::printf("%s\n", where.c_str());
    std::fflush(stdout);
    CHECK(verdict(height <= promise, where));
}

}  // namespace

TEMPLATE_TEST_CASE("no climb exceeds what is promised", "", Sphere, Plane, Triangle, Square,
                   Cylinder, Cone, OrientedBox) {
    if (are_certified() && std::is_same_v<TestType, OrientedBox>) return;
    const Bars bars = bars_of<TestType>();
    if (bars.off < unbounded) hold<TestType>(Goal::off, "off", bars.off);
    if (bars.band < unbounded) hold<TestType>(Goal::band, "band", bars.band);
    if (bars.ulps < unbounded) hold<TestType>(Goal::ulps, "ulp", bars.ulps);
}
