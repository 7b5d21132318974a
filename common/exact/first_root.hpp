// The first hit of a ray, decided in twice the working precision, or else exactly: one template for
// both number types.
#pragma once

#include "common/exact/dyadic.hpp"
#include "common/geometry/ray.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <type_traits>

namespace rt {
inline namespace RT_PRECISION {

// A shape restricted to a ray: the roots in t of one quadratic at which some other polynomials are
// not negative. A template over the number type.

/// c0 + c1 t + c2 t².
template <class T>
struct Polynomial {
    T c0 = Real(0);
    T c1 = Real(0);
    T c2 = Real(0);
};

/// The intersection of a shape with a ray's line.
template <class T, std::size_t count>
struct Crossing {
    T a = Real(0);  ///< a t² + 2 b t + c = 0 at the intersections with the shape's whole surface
    T b = Real(0);
    T c = Real(0);
    std::array<Polynomial<T>, count>
        conditions;  ///< none is negative on the part that belongs to the shape
};

template <class T>
struct Triple {
    T x;
    T y;
    T z;

    friend Triple operator-(const Triple& v, const Triple& w) {
        return {v.x - w.x, v.y - w.y, v.z - w.z};
    }
};

/// A shape and a ray for evaluation in several number types: in units of `length_unit` and of the
/// ray's speed, crossing_in(T(), ray) returns a Crossing<T, …>.
template <class CrossingIn>
struct Along {
    Real length_unit;
    CrossingIn crossing_in;
};
template <class CrossingIn>
Along(Real, CrossingIn) -> Along<CrossingIn>;

}  // namespace RT_PRECISION
template <class T>
[[nodiscard]] T dot(const Triple<T>& v, const Triple<T>& w) {
    return v.x * w.x + v.y * w.y + v.z * w.z;
}

template <class T>
[[nodiscard]] Triple<T> cross(const Triple<T>& v, const Triple<T>& w) {
    return {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

template <class T>
[[nodiscard]] Triple<T> exactly(Vec3 v) {
    return {T(v.x), T(v.y), T(v.z)};
}

[[nodiscard]] inline DoubleDouble two_words(const DoubleDouble& number) {
    return number;
}
[[nodiscard]] inline DoubleDouble two_words(const Dyadic& number) {
    return number.rounded();
}

/// The sign of p + q √d for d that is not negative: if the signs of the two terms differ, the term
/// with the larger square decides.
[[nodiscard]] inline std::optional<int> sign_of_sum(const Dyadic& p, const Dyadic& q,
                                                    const Dyadic& d) {
    const auto first = p.sign();
    const auto second = (q * d).sign();
    if (!first || !second) return std::nullopt;
    if (*first * *second >= 0) return *first != 0 ? first : second;
    const auto larger = (p * p - q * q * d).sign();
    if (!larger) return std::nullopt;
    return *first * *larger;
}

inline namespace RT_PRECISION {

/// (rational + surd √radicand) / denominator, which is positive; surd is -1, 0 or 1.
template <class T>
struct Root {
    T rational;
    int surd = 0;
    T radicand;
    T denominator;
    DoubleDouble value;

    /// The sign of a polynomial at this root; nothing if two words cannot decide it.
    [[nodiscard]] std::optional<int> sign_of(const Polynomial<T>& p) const {
        const DoubleDouble there =
            (two_words(p.c2) * value + two_words(p.c1)) * value + two_words(p.c0);
        auto sign = there.sign();
        if constexpr (std::is_same_v<T, Dyadic>)
            if (!sign) {
                const T& n = denominator;
                const T square = rational * rational + T(Real(surd * surd)) * radicand;
                sign = sign_of_sum(p.c0 * n * n + p.c1 * n * rational + p.c2 * square,
                                   T(Real(surd)) * (p.c1 * n + (p.c2 + p.c2) * rational), radicand);
            }
        return sign;
    }
};

/// An exactly known root.
struct ExactRoot : Root<Dyadic> {};

/// The intersections of a ray with a surface, in increasing order.
template <class T>
struct Roots {
    bool certain = true;
    std::size_t count = 0;
    std::array<Root<T>, 2> roots;
};

/// The real roots of a t² + 2 b t + c; empty if all three coefficients are 0.
template <class T>
[[nodiscard]] Roots<T> roots_of(T a, T b, T c) {
    const auto opens = a.sign();
    if (!opens) return {.certain = false};
    if (*opens == 0) {
        const auto rises = b.sign();
        if (!rises) return {.certain = false};
        if (*rises == 0) return {};
        if (*rises < 0) {
            b = -b;
            c = -c;
        }
        const DoubleDouble value = two_words(-c) / two_words(b + b);
        return {.count = 1,
                .roots = {Root<T>{.rational = -c, .denominator = b + b, .value = value}, {}}};
    }
    if (*opens < 0) {
        a = -a;
        b = -b;
        c = -c;
    }
    const T radicand = b * b - a * c;
    const auto real = radicand.sign();
    if (!real) return {.certain = false};
    if (*real < 0) return {};
    const DoubleDouble middle = -two_words(b);
    if (*real == 0) {
        const DoubleDouble value = middle / two_words(a);
        return {.count = 1,
                .roots = {Root<T>{.rational = -b, .denominator = a, .value = value}, {}}};
    }
    // The root of larger magnitude is a sum without cancellation; the other one follows from their
    // product c / a.
    const DoubleDouble half_chord = square_root(two_words(radicand));
    const bool positive = middle.high > 0;
    const DoubleDouble sum = positive ? middle + half_chord : middle - half_chord;
    const DoubleDouble further = sum / two_words(a);
    const DoubleDouble nearer = two_words(c) / sum;
    return {.count = 2,
            .roots = {Root<T>{.rational = -b,
                              .surd = -1,
                              .radicand = radicand,
                              .denominator = a,
                              .value = positive ? nearer : further},
                      Root<T>{.rational = -b,
                              .surd = 1,
                              .radicand = radicand,
                              .denominator = a,
                              .value = positive ? further : nearer}}};
}

/// The first root of a shape, or none; not certain if more digits are necessary.
template <class T>
struct FirstRoot {
    bool certain = true;
    std::optional<Root<T>> root = std::nullopt;
};

/// The first intersection on the shape strictly inside the interval.
template <class T, std::size_t count>
[[nodiscard]] FirstRoot<T> first_root(const Crossing<T, count>& crossing, Interval interval) {
    const Roots<T> found = roots_of(crossing.a, crossing.b, crossing.c);
    if (!found.certain) return {.certain = false};
    for (std::size_t i = 0; i < found.count; ++i) {
        const Root<T>& root = found.roots[i];
        auto after = root.sign_of({.c0 = T(-interval.min), .c1 = Real(1)});
        if (!after) return {.certain = false};
        if (*after <= 0) continue;
        if (interval.max < infinity) {
            const auto before = root.sign_of({.c0 = T(interval.max), .c1 = Real(-1)});
            if (!before) return {.certain = false};
            if (*before <= 0) return {};
        }
        bool belongs = true;
        for (const Polynomial<T>& condition : crossing.conditions) {
            const auto sign = root.sign_of(condition);
            if (!sign) return {.certain = false};
            belongs = belongs && *sign >= 0;
        }
        if (belongs) return {.root = root};
    }
    return {};
}

/// A decided result; not certain if more digits are necessary.
struct Decision {
    bool certain = true;
    std::optional<Real> t = std::nullopt;
};

/// The ray and the interval in units of about the shape's size and the ray's speed, so that
/// products stay in the range of numbers. The units are powers of two, so scaling is exact.
struct InUnits {
    Ray ray;
    Interval interval;
    Real time_unit;

    InUnits(const Ray& in_scene, Real length_unit, Interval in_time) {
        const Real speed_unit = power_of_two_below(largest_component(in_scene.direction));
        time_unit = length_unit / speed_unit;
        ray = {.origin = in_scene.origin / length_unit,
               .direction = in_scene.direction / speed_unit};
        interval = {.min = in_time.min / time_unit, .max = in_time.max / time_unit};
    }
};

}  // namespace RT_PRECISION

/// The t of the first hit of a shape, rounded. Nothing if there is none, or if a number is infinite
/// or NaN.
template <class CrossingIn>
[[nodiscard]] std::optional<Real> decided(const Ray& ray, const Along<CrossingIn>& shape,
                                          Interval interval) {
    const InUnits asked(ray, shape.length_unit, interval);
    const auto decide = [&]<class T>(T number) -> Decision {
        const auto found = first_root(shape.crossing_in(number, asked.ray), asked.interval);
        if (!found.certain || !found.root) return {.certain = found.certain};
        const DoubleDouble& t = found.root->value;
        return {.certain = t.error <= unit_roundoff * std::abs(t.high), .t = t.high};
    };
    Decision decision = decide(DoubleDouble());
    if (!decision.certain) decision = decide(Dyadic());
    if (!decision.certain || !decision.t) return std::nullopt;
    // The root is inside the interval; rounding to one word may move it outside, which is corrected
    // here unless t becomes infinite.
    Real t = *decision.t * asked.time_unit;
    if (t == infinity) return std::nullopt;
    if (t <= interval.min) t = std::nextafter(interval.min, infinity);
    if (t >= interval.max) t = std::nextafter(interval.max, -infinity);
    if (!interval.contains(t)) return std::nullopt;  // the interval contains no Real
    return t;
}

}  // namespace rt
