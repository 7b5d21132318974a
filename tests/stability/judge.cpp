#include "tests/stability/judge.hpp"

#include "common/math/vector.hpp"
#include "tests/oracle/distances.hpp"
#include "tests/oracle/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt {

namespace {

using oracle::ExactVector;
using oracle::Number;
using oracle::Root;

Real reach(const Sphere& sphere) {
    return largest_component(sphere.center) + sphere.radius;
}

Real reach(const Plane& plane) {
    return largest_component(plane.point);
}

Real reach(const Triangle& triangle) {
    return std::max({largest_component(triangle.a), largest_component(triangle.b),
                     largest_component(triangle.c)});
}

Real reach(const Square& square) {
    return largest_component(square.center) + square.side / 2;
}

Real reach(const Cylinder& cylinder) {
    return largest_component(cylinder.center) + std::max(cylinder.radius, cylinder.height / 2);
}

Real reach(const Cone& cone) {
    return largest_component(cone.apex) + std::max(cone.radius, cone.height);
}

/// u L.
template <class Shape>
double unit_of(const Case<Shape>& asked, std::optional<Real> got) {
    Real largest = std::max(largest_component(asked.ray.origin), reach(asked.shape));
    if (got) largest = std::max(largest, largest_component(at(asked.ray, *got)));
    return double(unit_roundoff) * double(largest);
}

ExactVector point_at(const oracle::Ray& ray, Real t) {
    return ray.origin + oracle::Exact(t) * ray.direction;
}

/// The shape's first hit in the interval, and whether the ray crosses its surface anywhere else.
struct Answer {
    std::vector<Number> roots;
    std::optional<std::size_t> first;
};

template <class Shape>
Answer answer(const oracle::Ray& ray, const Shape& shape, const oracle::Interval& interval) {
    Answer answer;
    for (const Root& root : roots(ray, shape)) {
        if (!answer.first && contains(interval, root) && belongs(ray, shape, root))
            answer.first = answer.roots.size();
        answer.roots.push_back(root.value());
    }
    return answer;
}

/// True if the answers agree: both miss, or both hit at the same root. Near a silhouette the two
/// roots are ill-conditioned, but their middle is not: a hit is at the other root if it is within a
/// quarter of the distance to it, and that distance exceeds the rounding error.
bool same(std::optional<Real> got, const Answer& exact, const Number& rounding) {
    if (!got || !exact.first) return got.has_value() == exact.first.has_value();
    const Number& first = exact.roots[*exact.first];
    return std::ranges::all_of(exact.roots, [&](const Number& other) {
        const Number way = abs(other - first);
        return way <= rounding || abs(other - *got) > way / 4;
    });
}

/// A few u L, converted to a difference of t.
template <class Shape>
Number rounding(const Case<Shape>& asked, double unit) {
    return 64 * unit / length(exact(asked.ray.direction));
}

double ulps_between(Real got, const Number& expected) {
    // An ulp of the exact value, within Real's range.
    const auto nearest = expected.convert_to<Real>();
    if (!(nearest < infinity)) return 0;
    const Real next = std::nextafter(nearest, Real(0));
    return abs((Number(got) - expected) / (Number(nearest) - Number(next))).convert_to<double>();
}

/// True if the answer is right for a ray that is moved by this much, across itself or along, or
/// both at 45°.
template <class Shape>
bool right_if_moved(const Case<Shape>& asked, std::optional<Real> got, double distance) {
    constexpr int ways = 16;
    const glm::dvec3 d =
        glm::normalize(glm::dvec3(asked.ray.direction / largest_component(asked.ray.direction)));
    const glm::dvec3 other = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(d, other));
    const glm::dvec3 y = glm::cross(d, x);
    const auto shape = exact(asked.shape);
    const auto interval = exact(asked.interval);
    const auto right = [&](glm::dvec3 move) {
        oracle::Ray ray = exact(asked.ray);
        move *= distance;
        ray.origin = ray.origin + ExactVector{move.x, move.y, move.z};
        return same(got, answer(ray, shape, interval), rounding(asked, distance));
    };
    // At an end of the interval and beside an edge, neither a move across nor one along is enough.
    if (right(d) || right(-d)) return true;
    for (int i = 0; i < ways; ++i) {
        const double angle = 2 * std::numbers::pi * i / ways;
        const glm::dvec3 aside = std::cos(angle) * x + std::sin(angle) * y;
        if (right(aside) || right(glm::normalize(aside + d)) || right(glm::normalize(aside - d)))
            return true;
    }
    return false;
}

}  // namespace

template <class Shape>
Judgment judged(const Case<Shape>& asked, std::optional<Real> got) {
    const oracle::Ray ray = exact(asked.ray);
    const auto shape = exact(asked.shape);
    const double unit = unit_of(asked, got);
    const Answer expected = answer(ray, shape, exact(asked.interval));
    Judgment judgment{.wrong = !same(got, expected, rounding(asked, unit))};
    if (!got) return judgment;
    judgment.off =
        Number(off_surface(point_at(ray, *got), shape) / unit).template convert_to<double>();
    if (!judgment.wrong) judgment.ulps = ulps_between(*got, expected.roots[*expected.first]);
    return judgment;
}

template <class Shape>
bool starts_on(const Case<Shape>& asked) {
    return off_surface(exact(asked.ray.origin), exact(asked.shape)) <= 16 * unit_of(asked, {});
}

template <class Shape>
double band(const Case<Shape>& asked, std::optional<Real> got, double known) {
    const double unit = unit_of(asked, got);
    const oracle::Ray ray = exact(asked.ray);
    const auto shape = exact(asked.shape);
    double direct = std::numeric_limits<double>::infinity();
    if (got && !answer(ray, shape, exact(asked.interval)).first) {
        const ExactVector point = point_at(ray, *got);
        Number way = gap(ray, point, shape) / unit;
        // The ray hits the shape, but not in the interval, which may be shorter than any move.
        if (way <= 0) way = off_surface(point, shape) / unit;
        direct = way.template convert_to<double>();
    }
    if (direct <= known) return known;
    constexpr double most = 1e6;  // more than that is no longer a matter of rounding
    if (known >= most || right_if_moved(asked, got, known * unit)) return known;
    // Between two rims, a large move may be wrong again although a small one is right.
    constexpr double step = 1.125;
    double distance = 1.0 / 64;
    while (distance < std::min(direct, most) && !right_if_moved(asked, got, distance * unit))
        distance *= step;
    return std::max(known, std::min(distance, direct));
}

template <class Shape>
std::optional<Real> exact_answer(const Case<Shape>& asked) {
    const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(asked.interval));
    if (!root) return std::nullopt;
    return root->value().template convert_to<Real>();
}

template Judgment judged(const Case<Sphere>&, std::optional<Real>);
template bool starts_on(const Case<Sphere>&);
template double band(const Case<Sphere>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Sphere>&);
template Judgment judged(const Case<Plane>&, std::optional<Real>);
template bool starts_on(const Case<Plane>&);
template double band(const Case<Plane>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Plane>&);
template Judgment judged(const Case<Triangle>&, std::optional<Real>);
template bool starts_on(const Case<Triangle>&);
template double band(const Case<Triangle>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Triangle>&);
template Judgment judged(const Case<Square>&, std::optional<Real>);
template bool starts_on(const Case<Square>&);
template double band(const Case<Square>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Square>&);
template Judgment judged(const Case<Cylinder>&, std::optional<Real>);
template bool starts_on(const Case<Cylinder>&);
template double band(const Case<Cylinder>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Cylinder>&);
template Judgment judged(const Case<Cone>&, std::optional<Real>);
template bool starts_on(const Case<Cone>&);
template double band(const Case<Cone>&, std::optional<Real>, double);
template std::optional<Real> exact_answer(const Case<Cone>&);

}  // namespace rt
