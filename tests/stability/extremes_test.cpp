// The limits of floating point: d = 0, NaN, infinities, subnormal numbers, t out of range. Every
// answer is a miss, or strictly inside the interval; and NaN and d = 0 miss.
#include "tests/stability/sweeps.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include "tests/kit/shape_checks.hpp"

using namespace rt;

namespace {

using Limits = std::numeric_limits<Real>;

constexpr std::array edges = {Real(0),
                              Real(-0.0),
                              Limits::denorm_min(),
                              Limits::min(),
                              -Limits::denorm_min(),
                              -Limits::min(),
                              Limits::max(),
                              -Limits::max(),
                              infinity,
                              -infinity,
                              Limits::quiet_NaN()};

/// Every number of a ray and a shape, to be replaced.
template <class Shape>
std::vector<Real*> numbers(Case<Shape>& asked) {
    auto* first = reinterpret_cast<Real*>(&asked.shape);
    std::vector<Real*> all;
    for (Vec3* v : {&asked.ray.origin, &asked.ray.direction})
        for (glm::length_t i = 0; i < 3; ++i) all.push_back(&(*v)[i]);
    constexpr std::size_t count = sizeof(Shape) / sizeof(Real);  // a square's flag apart
    constexpr bool has_flag = requires {
        asked.shape.one_sided;
    };
    for (std::size_t i = 0; i < count - (has_flag ? 1 : 0); ++i) all.push_back(first + i);
    return all;
}

template <class Shape>
Verdict is_sound(const Case<Shape>& asked, Interval interval) {
    const auto got = intersect(asked.ray, asked.shape, interval);
    return verdict(!got || interval.contains(*got),
                   intersection_report(asked.ray, asked.shape, interval, got, std::nullopt));
}

template <class Shape>
Case<Shape> drawn_case(Random& random) {
    Case<Shape> asked;
    draw(random, random.coin() ? Sweep::moderate : Sweep::border, asked);
    return asked;
}

}  // namespace

TEMPLATE_TEST_CASE("with any number at the edge, an answer is none or inside the interval", "",
                   Sphere, Plane, Triangle, Square, Cylinder, Cone) {
    CHECK(for_all(
        [](Random& random) {
            auto asked = drawn_case<TestType>(random);
            auto all = numbers(asked);
            for (int i = random.below(3); i >= 0; --i)
                *all[std::size_t(random.below(int(all.size())))] =
                    edges[std::size_t(random.below(int(edges.size())))];
            const Interval interval{.min = random.coin() ? 0 : random.between(0, 4),
                                    .max = random.coin() ? infinity : random.between(4, 8)};
            return is_sound(asked, interval);
        },
        20'000));
}

TEMPLATE_TEST_CASE("NaN anywhere misses", "", Sphere, Plane, Triangle, Square, Cylinder, Cone) {
    CHECK(for_all(
        [](Random& random) {
            auto asked = drawn_case<TestType>(random);
            auto all = numbers(asked);
            *all[std::size_t(random.below(int(all.size())))] = Limits::quiet_NaN();
            return misses(asked.ray, asked.shape);
        },
        10'000));
}

TEMPLATE_TEST_CASE("a ray without direction misses", "", Sphere, Plane, Triangle, Square, Cylinder,
                   Cone) {
    CHECK(for_all(
        [](Random& random) {
            auto asked = drawn_case<TestType>(random);
            asked.ray.direction = Vec3(random.coin() ? Real(0) : Real(-0.0));
            return misses(asked.ray, asked.shape);
        },
        10'000));
}

TEMPLATE_TEST_CASE("a shape so far that t is no number is missed, or at a t that is one", "",
                   Sphere, Plane, Triangle, Square, Cylinder, Cone) {
    CHECK(for_all(
        [](Random& random) {
            auto asked = drawn_case<TestType>(random);
            asked.ray.direction *= std::ldexp(Limits::min(), -random.below(Limits::digits));
            asked.ray.origin *= std::ldexp(Real(1), random.below(Limits::max_exponent - 4));
            return is_sound(asked, {});
        },
        10'000));
}

TEST_CASE("a direction with subnormal components is as good as any: the target is hit") {
    const Real least = Limits::denorm_min();
    for (const Real a : {least, -least, Limits::min(), Real(0)}) {
        const Ray ray{.origin = {0, 0, 5}, .direction = {a, -a, -1}};
        CHECK(hits(ray, Sphere{.center = {0, 0, 0}, .radius = 1}, 4));
        CHECK(hits(ray, Plane{.point = {7, 1, 0}, .normal = {0, 0, 1}}, 5));
        CHECK(hits(ray, Triangle{.a = {-1, -1, 0}, .b = {2, -1, 0}, .c = {-1, 2, 0}}, 5));
        CHECK(hits(ray, Square{}, 5));
        CHECK(hits(ray, Cylinder{.axis = {0, 1, 0}, .radius = 1, .height = 2}, 4));
        CHECK(hits(ray, Cone{.apex = {0, 1, 0}, .axis = {0, -1, 0}, .radius = 2, .height = 2}, 4));
    }
}
