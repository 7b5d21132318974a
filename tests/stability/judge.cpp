#include "tests/stability/judge.hpp"

#include "common/geometry/cone.hpp"
#include "common/geometry/cylinder.hpp"
#include "common/geometry/oriented_box.hpp"
#include "common/geometry/plane.hpp"
#include "common/geometry/ray.hpp"
#include "common/geometry/sphere.hpp"
#include "common/geometry/square.hpp"
#include "common/geometry/triangle.hpp"
#include "common/math/vector.hpp"

#include "tests/oracle/distances.hpp"
#include "tests/oracle/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

// Distances from surfaces in long double, which are fast and, where it has more digits than Real,
// accurate enough to dismiss most steps of a climb. In double on x86 it has 11 bits more.
namespace rt::wide {
namespace {

using Number = long double;
using Vector = glm::vec<3, Number>;

constexpr bool has_more_digits =
    std::numeric_limits<Number>::digits >= std::numeric_limits<Real>::digits + 8;

Number off_plane(Vector v, Vector n) {
    return std::abs(dot(v, n)) / length(n);
}

Number off_surface(Vector p, const Sphere& s) {
    return std::abs(length(p - Vector(s.center)) - Number(s.radius));
}

Number off_surface(Vector p, const Plane& s) {
    return off_plane(p - Vector(s.point), Vector(s.normal));
}

Number off_surface(Vector p, const Triangle& t) {
    const Vector a(t.a);
    return off_plane(p - a, cross(Vector(t.b) - a, Vector(t.c) - a));
}

Number off_surface(Vector p, const Square& s) {
    return off_plane(p - Vector(s.center), Vector(s.basis.z));
}

Number off_surface(Vector p, const Cylinder& c) {
    const Vector axis(c.axis);
    return std::abs(length(cross(p - Vector(c.center), axis)) / length(axis) - Number(c.radius));
}

Number off_surface(Vector p, const Cone& c) {
    const Vector z = Vector(c.axis) / length(Vector(c.axis));
    const Vector v = p - Vector(c.apex);
    const Number r = c.radius;
    const Number h = c.height;
    return std::abs(length(cross(v, z)) * h - std::abs(dot(v, z)) * r) / std::sqrt(r * r + h * h);
}

Number off_surface(Vector p, const OrientedBox& box) {
    const auto beyond = [&](Vec3 axis, Real half) {
        const Vector wide(axis);
        return (std::abs(dot(p - Vector(box.center), wide)) - Number(half)) / length(wide);
    };
    const auto& [x, y, z] = box.basis;
    const Vector v(beyond(x, box.half_size.x), beyond(y, box.half_size.y),
                   beyond(z, box.half_size.z));
    const Number most = std::max({v.x, v.y, v.z});
    return most < 0 ? -most : length(max(v, Vector(0)));
}

/// The distance of the ray's point at t.
template <class Shape>
Number off_surface(const Ray& ray, Real t, const Shape& shape) {
    return off_surface(Vector(ray.origin) + Number(t) * Vector(ray.direction), shape);
}

}  // namespace
}  // namespace rt::wide

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

Real reach(const OrientedBox& box) {
    return largest_component(box.center) + largest_component(box.half_size);
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

/// The unit directions in which a ray is moved: along itself, across, and at 45°. At an end of the
/// interval and beside an edge, neither a move across nor one along is enough.
std::vector<glm::dvec3> ways_to_move(const Ray& ray) {
    constexpr int turns = 16;
    const glm::dvec3 d =
        glm::normalize(glm::dvec3(ray.direction / largest_component(ray.direction)));
    const glm::dvec3 other = std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(d, other));
    const glm::dvec3 y = glm::cross(d, x);
    std::vector<glm::dvec3> ways = {d, -d};
    for (int i = 0; i < turns; ++i) {
        const double angle = 2 * std::numbers::pi * i / turns;
        const glm::dvec3 aside = std::cos(angle) * x + std::sin(angle) * y;
        ways.insert(ways.end(), {aside, glm::normalize(aside + d), glm::normalize(aside - d)});
    }
    return ways;
}

/// The exact answers for a ray that is moved, against the one that was given.
template <class Shape>
class Moves {
public:
    Moves(const Case<Shape>& asked, std::optional<Real> got, double unit)
        : asked_(asked),
          got_(got),
          unit_(unit),
          ways_(ways_to_move(asked.ray)),
          shape_(exact(asked.shape)),
          before_(ways_.size(), outcome(glm::dvec3(0))) {}

    /// Returns whether the answer is right for a ray moved by this distance, in u L, in any way; or
    /// by less than this, and more than the distance of the call before, if the exact answers at
    /// these two differ: between two answers there may be a narrow window with a third.
    bool right_within(double distance) {
        bool right = false;
        for (std::size_t i = 0; i < ways_.size(); ++i) {
            const Outcome after = outcome(distance * ways_[i]);
            if (after.right ||
                (after.root != before_[i].root && right_between(ways_[i], before_[i], distance)))
                right = true;
            before_[i] = after;
            if (right) break;
        }
        reached_ = distance;
        return right;
    }

private:
    struct Outcome {
        bool right;
        std::optional<std::size_t> root;  ///< the index of the first hit
    };

    Outcome outcome(glm::dvec3 move) const {
        oracle::Ray ray = exact(asked_.ray);
        move *= unit_;
        ray.origin = ray.origin + ExactVector{move.x, move.y, move.z};
        const Answer moved = answer(ray, shape_, exact(asked_.interval));
        return {.right = same(got_, moved, rounding(asked_, glm::length(move))),
                .root = moved.first};
    }

    /// Bisects to where the answer changes.
    bool right_between(glm::dvec3 way, Outcome before, double far) const {
        double near = reached_;
        for (int i = 0; i < 60; ++i) {
            const double middle = near + (far - near) / 2;
            const Outcome there = outcome(middle * way);
            if (there.right) return true;
            (there.root == before.root ? near : far) = middle;
        }
        return false;
    }

    const Case<Shape>& asked_;
    std::optional<Real> got_;
    double unit_;  ///< u L
    std::vector<glm::dvec3> ways_;
    decltype(exact(std::declval<Shape>())) shape_;
    double reached_ = 0;
    std::vector<Outcome> before_;  ///< at that distance, in each way
};

}  // namespace

template <class Shape>
double unit_of(const Case<Shape>& asked, std::optional<Real> got) {
    Real largest = std::max(largest_component(asked.ray.origin), reach(asked.shape));
    if (got) largest = std::max(largest, largest_component(at(asked.ray, *got)));
    return double(unit_roundoff) * double(largest);
}

template <class Shape>
double off(const Case<Shape>& asked, Real got, double known) {
    const double unit = unit_of(asked, got);
    if (wide::has_more_digits && known > 0 &&
        wide::off_surface(asked.ray, got, asked.shape) < 0.98 * known * unit)
        return 0;
    const Number distance = off_surface(point_at(exact(asked.ray), got), exact(asked.shape));
    return Number(distance / unit).template convert_to<double>();
}

template <class Shape>
Judgment judged(const Case<Shape>& asked, std::optional<Real> got) {
    const oracle::Ray ray = exact(asked.ray);
    const auto shape = exact(asked.shape);
    const double unit = unit_of(asked, got);
    const Answer expected = answer(ray, shape, exact(asked.interval));
    Judgment judgment{.wrong = !same(got, expected, rounding(asked, unit))};
    if (!got) return judgment;
    judgment.off = off(asked, *got, 0);
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
    if (known >= most) return known;
    Moves<Shape> moves(asked, got, unit);
    if (known > 0 && moves.right_within(known)) return known;
    // Between two rims, a large move may be wrong again although a small one is right.
    constexpr double step = 1.125;
    double distance = 1.0 / 64;
    Moves<Shape> steps(asked, got, unit);
    while (distance < std::min(direct, most) && !steps.right_within(distance)) distance *= step;
    return std::max(known, std::min(distance, direct));
}

template <class Shape>
std::optional<Real> exact_answer(const Case<Shape>& asked) {
    const auto root = intersect(exact(asked.ray), exact(asked.shape), exact(asked.interval));
    if (!root) return std::nullopt;
    return root->value().template convert_to<Real>();
}

#define RT_JUDGE(Shape)                                                    \
    template double unit_of(const Case<Shape>&, std::optional<Real>);      \
    template double off(const Case<Shape>&, Real, double);                 \
    template Judgment judged(const Case<Shape>&, std::optional<Real>);     \
    template bool starts_on(const Case<Shape>&);                           \
    template double band(const Case<Shape>&, std::optional<Real>, double); \
    template std::optional<Real> exact_answer(const Case<Shape>&);

RT_JUDGE(Sphere)
RT_JUDGE(Plane)
RT_JUDGE(Triangle)
RT_JUDGE(Square)
RT_JUDGE(Cylinder)
RT_JUDGE(Cone)
RT_JUDGE(OrientedBox)

}  // namespace rt
