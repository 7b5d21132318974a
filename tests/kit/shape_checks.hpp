// Properties of every shape, tested with random cases. A suite defines the random shapes and points
// on them; everything else follows from geometry.
#pragma once

#include "tests/kit/for_all.hpp"

#include "common/geometry/cone.hpp"
#include "common/geometry/transform.hpp"

#include <cmath>

namespace rt {

/// A share of a size from far above the rounding of a right answer to less than 0.1 %: many are
/// about a millionth, in double.
inline Real draw_narrow(Random& random) {
    const Real least = std::sqrt(epsilon);
    return least * std::pow(Real(0.0009) / least, random.between(0, 1));
}

/// A share of a size from well above the rounding of a textbook's formula, even beside a tangent,
/// to 1: in double, many are less than a thousandth.
inline Real draw_gap(Random& random) {
    const Real least = sizeof(Real) == sizeof(float) ? Real(0.002) : Real(1e-7);
    return std::pow(least, random.between(0, 1));
}

/// A share of a size that is above rounding where almost nothing is rounded.
constexpr Real hair = sizeof(Real) == sizeof(float) ? Real(0x1p-18) : Real(0x1p-40);

/// Any rotation, and in one of eight cases one that maps axes to axes: some wrong answers are wrong
/// there alone.
inline Basis draw_basis(Random& random) {
    return random.below(8) == 0 ? random.axes() : random.basis();
}

/// A shape, a point of its surface well inside any edge, and the outward unit normal there.
template <class Shape>
struct Sample {
    Shape shape;
    Vec3 point;
    Vec3 normal;
};

/// A ray that hits a shape first at t, and where.
template <class Shape>
struct Aimed {
    Ray ray;
    Shape shape;
    Real t;
    Vec3 point;
    Vec3 normal;
};

/// Returns whether a ray in this direction runs almost along a line of a cone's side. A textbook's
/// quadratic then has almost no square term, and few digits; stage 8's suite asks that separately.
template <class Shape>
bool nearly_along_side(const Shape& /*shape*/, Vec3 /*direction*/) {
    return false;
}
inline bool nearly_along_side(const Cone& cone, Vec3 direction) {
    const Real across = cone.height * length(cross(direction, cone.axis));
    const Real along = cone.radius * std::abs(dot(direction, cone.axis));
    return std::abs(across - along) < Real(0.05) * (across + along);
}

/// A ray to a sample's point, from the side of its normal. Every shape here lies behind its tangent
/// plane at that point, so the ray hits nothing before it.
template <class Shape>
Aimed<Shape> aimed_from_outside(const Sample<Shape>& sample, Random& random) {
    constexpr int most_tries = 100;  // a reduced case may repeat a direction without end
    Vec3 away;
    for (int i = 0; i < most_tries; ++i) {
        away = random.direction();
        if (dot(away, sample.normal) < 0) away = -away;
        if (dot(away, sample.normal) < Real(0.2)) away += sample.normal;  // not too grazing
        if (!nearly_along_side(sample.shape, away)) break;
    }
    const Vec3 origin = sample.point + random.between(Real(0.5), 4) * away;
    const Real t = random.between(Real(0.25), 4);
    return {.ray = {.origin = origin, .direction = (sample.point - origin) / t},
            .shape = sample.shape,
            .t = t,
            .point = sample.point,
            .normal = sample.normal};
}

/// Anything that turns, scales by a power of two, and moves by a few of its sizes.
inline Transform random_motion(Random& random) {
    Transform transform;
    transform.rotation = random.basis();
    transform.scale = random.power_of_two();
    transform.translation = transform.scale * random.point(4);
    return transform;
}

// The parameter `draw` of each function makes a Sample<Shape> from a Random.

/// A ray aimed at a point from outside hits there, whatever the length of its direction.
template <class Draw>
Verdict aimed_rays_hit(Draw draw) {
    return for_all([draw](Random& random) {
        const auto aimed = aimed_from_outside(draw(random), random);
        const Real length = random.power_of_two();
        const Ray ray{.origin = aimed.ray.origin, .direction = length * aimed.ray.direction};
        return hits(ray, aimed.shape, aimed.t / length);
    });
}

/// The same ray, turned round, has the shape behind it.
template <class Draw>
Verdict nothing_behind_is_hit(Draw draw) {
    return for_all([draw](Random& random) {
        const auto aimed = aimed_from_outside(draw(random), random);
        return misses({.origin = aimed.ray.origin, .direction = -aimed.ray.direction}, aimed.shape);
    });
}

/// A ray that starts very close to the surface, on either side, hits it at once. A textbook's
/// formula has a few digits of this t left, and only these are tested.
template <class Draw>
Verdict close_surfaces_are_hit(Draw draw) {
    return for_all([draw](Random& random) {
        const auto sample = draw(random);
        const Real gap = std::ldexp(Real(1), sizeof(Real) == sizeof(float) ? -10 : -20);
        const Vec3 away = random.coin() ? sample.normal : -sample.normal;
        const Ray ray{.origin = sample.point + gap * away, .direction = -away};
        const std::optional<Real> t = intersect(ray, sample.shape, {});
        return verdict(t && std::abs(*t - gap) < gap / 8,
                       [&] { return intersection_report(ray, sample.shape, {}, t, gap); });
    });
}

/// A shape is hit from far away, where a textbook's formula has half of its digits left.
template <class Draw>
Verdict far_shapes_are_hit(Draw draw) {
    return for_all([draw](Random& random) {
        const auto near = aimed_from_outside(draw(random), random);
        const Real expected = std::ldexp(Real(1), sizeof(Real) == sizeof(float) ? 4 : 14) * near.t;
        const Vec3 direction = near.ray.direction;
        const Ray ray{.origin = near.point - expected * direction, .direction = direction};
        const std::optional<Real> got = intersect(ray, near.shape, {});
        return verdict(got && std::abs(*got - expected) < std::sqrt(epsilon) * expected,
                       [&] { return intersection_report(ray, near.shape, {}, got, expected); });
    });
}

/// A t is outside an interval that begins or ends with it. (An answer that decides exactly may find
/// the hit inside, and round its t to the next number.)
template <class Shape>
Verdict ends_are_outside(const Ray& ray, const Shape& shape) {
    const std::optional<Real> t = intersect(ray, shape, {});
    if (!t) return {};
    for (const Interval interval :
         {Interval{.min = 0, .max = *t}, Interval{.min = *t, .max = infinity}}) {
        const std::optional<Real> got = intersect(ray, shape, interval);
        if (got == t)
            return verdict(false, intersection_report(ray, shape, interval, got, std::nullopt));
    }
    return {};
}

/// A hit counts strictly inside the interval only.
template <class Draw>
Verdict interval_is_kept(Draw draw) {
    const Verdict kept = for_all([draw](Random& random) {
        const auto [ray, shape, t, point, normal] = aimed_from_outside(draw(random), random);
        const Interval around{.min = t * Real(0.99), .max = t * Real(1.01)};
        const Interval before{.min = 0, .max = t * Real(0.99)};
        if (const Verdict hit = hits(ray, shape, t, around); !hit) return hit;
        return misses(ray, shape, before);
    });
    if (!kept) return kept;
    // A few: answers that are rounded differently answer these questions differently.
    constexpr int few = 4;
    return for_all(
        [draw](Random& random) {
            const auto aimed = aimed_from_outside(draw(random), random);
            return ends_are_outside(aimed.ray, aimed.shape);
        },
        few);
}

/// After a rigid transform of ray and shape, the hit is the transformed hit.
template <class Draw>
Verdict motion_changes_nothing(Draw draw) {
    return for_all([draw](Random& random) {
        const auto aimed = aimed_from_outside(draw(random), random);
        const Transform transform = random_motion(random);
        const auto shape = transformed(aimed.shape, transform);
        const Vec3 point = transformed(aimed.point, transform);
        if (const Verdict hit = hits(transformed(aimed.ray, transform), shape, aimed.t); !hit)
            return hit;
        return normal_is(shape, point, rotated(aimed.normal, transform));
    });
}

/// The normal at a point is outward and of unit length, on a shape of any size.
template <class Draw>
Verdict normals_point_outward(Draw draw) {
    return for_all([draw](Random& random) {
        const auto [shape, point, normal] = draw(random);
        const Transform scaling{.scale = std::ldexp(Real(1), random.below(41) - 20)};
        return normal_is(transformed(shape, scaling), transformed(point, scaling), normal);
    });
}

/// A coordinate of the ray, or of the shape's place, that is not a number makes a miss.
template <class Draw>
Verdict nan_misses(Draw draw) {
    return for_all([draw](Random& random) {
        const auto aimed = aimed_from_outside(draw(random), random);
        Ray ray = aimed.ray;
        Transform move;
        Vec3* const parts[] = {&ray.origin, &ray.direction, &move.translation};
        (*parts[random.below(3)])[random.below(3)] = std::numeric_limits<Real>::quiet_NaN();
        return misses(ray, transformed(aimed.shape, move));
    });
}

}  // namespace rt
