// The first hit of a ray, decided with twice the digits, or with as many as it takes.
//
// A shape says what it is along the ray: where it is a polynomial's root, on the part of it where
// others are not negative. In what numbers is left open, and so is the question asked of both.
#pragma once

#include "common/exact/expansion.hpp"
#include "common/ray.hpp"
#include "common/vector.hpp"

#include <algorithm>
#include <type_traits>

namespace rt::inline RT_PRECISION {

/// c0 + c1 t + c2 t².
template <class T>
struct Polynomial {
    T c0 = Real(0);
    T c1 = Real(0);
    T c2 = Real(0);
};

/// What a shape is along a ray.
template <class T, std::size_t count>
struct Crossing {
    T a = Real(0);  ///< a t² + 2 b t + c = 0 where the ray meets the whole of the surface
    T b = Real(0);
    T c = Real(0);
    std::array<Polynomial<T>, count> conditions;  ///< none of them negative on the shape's part
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

/// An answer, unless it must be asked again with more digits.
struct Decision {
    bool certain = true;
    std::optional<Real> t = std::nullopt;
};

}  // namespace rt::inline RT_PRECISION

namespace rt {

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

[[nodiscard]] inline TwoWords two_words(const TwoWords& number) {
    return number;
}
[[nodiscard]] inline TwoWords two_words(const Expansion& number) {
    return number.rounded();
}

}  // namespace rt

namespace rt::inline RT_PRECISION {

/// (rational + surd √radicand) / denominator, which is positive; surd is -1, 0 or 1.
template <class T>
struct Root {
    T rational;
    int surd = 0;
    T radicand;
    T denominator;
    TwoWords value;

    /// The sign of a polynomial there. Two words may leave it open.
    [[nodiscard]] std::optional<int> sign_of(const Polynomial<T>& p) const {
        const TwoWords there =
            (two_words(p.c2) * value + two_words(p.c1)) * value + two_words(p.c0);
        if (const auto sign = there.sign()) return sign;
        if constexpr (std::is_same_v<T, TwoWords>) return std::nullopt;
        const T& n = denominator;
        const T both = p.c0 * n * n + p.c1 * n * rational +
                       p.c2 * (rational * rational + T(Real(surd * surd)) * radicand);
        if (surd == 0) return both.sign();
        const T of_root = T(Real(surd)) * (p.c1 * n + (p.c2 + p.c2) * rational);
        // Where the two disagree, the larger square decides.
        const auto first = both.sign();
        const auto second = of_root.sign();  // the radicand is positive
        const auto larger = (both * both - of_root * of_root * radicand).sign();
        if (!first || !second || !larger) return std::nullopt;
        if (*first * *second >= 0) return *first != 0 ? first : second;
        return *first * *larger;
    }
};

/// Where a ray crosses a surface, in rising order.
template <class T>
struct Roots {
    bool certain = true;
    std::size_t count = 0;
    std::array<Root<T>, 2> roots;
};

/// The real roots of a t² + 2 b t + c; none if all three are 0.
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
        const TwoWords value = two_words(-c) / two_words(b + b);
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
    const TwoWords middle = -two_words(b);
    if (*real == 0) {
        const TwoWords value = middle / two_words(a);
        return {.count = 1,
                .roots = {Root<T>{.rational = -b, .denominator = a, .value = value}, {}}};
    }
    // The root further from 0 is a sum; of the other, their product c / a is known.
    const TwoWords half_chord = square_root(two_words(radicand));
    const bool positive = middle.high > 0;
    const TwoWords sum = positive ? middle + half_chord : middle - half_chord;
    const TwoWords further = sum / two_words(a);
    const TwoWords nearer = two_words(c) / sum;
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

/// The first of the crossings on the shape strictly inside the interval.
template <class T, std::size_t count>
[[nodiscard]] Decision first_hit(const Crossing<T, count>& crossing, Interval interval) {
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
        if (!belongs) continue;
        const Real t = root.value.high;
        return {.certain = root.value.error <= unit_roundoff * std::abs(t), .t = t};
    }
    return {};
}

}  // namespace rt::inline RT_PRECISION

namespace rt {

/// The first hit of a shape of which `crossing_in` says, in the numbers it is given an example of,
/// what it is along a ray. Both must be in units of about the shape's size and the ray's speed, or
/// products might leave the range of numbers. Nothing where a number is infinite or NaN.
template <class CrossingIn>
[[nodiscard]] std::optional<Real> decided(const Ray& ray, Real length_unit, Interval interval,
                                          const CrossingIn& crossing_in) {
    // Powers of two, by which nothing rounds.
    const Real speed_unit = power_of_two_below(largest_component(ray.direction));
    const Real time_unit = length_unit / speed_unit;
    const Ray near{.origin = ray.origin / length_unit, .direction = ray.direction / speed_unit};
    const Interval in_units{.min = interval.min / time_unit, .max = interval.max / time_unit};
    Decision decision = first_hit(crossing_in(TwoWords(), near), in_units);
    if (!decision.certain) decision = first_hit(crossing_in(Expansion(), near), in_units);
    if (!decision.certain || !decision.t) return std::nullopt;
    // Inside the interval, but for what rounding to one word does to it.
    Real t = *decision.t * time_unit;
    if (t <= interval.min) t = std::nextafter(interval.min, infinity);
    if (t >= interval.max) t = std::nextafter(interval.max, -infinity);
    if (!interval.contains(t)) return std::nullopt;  // or it has left the range of numbers
    return t;
}

}  // namespace rt
