// The exact intersection of a ray with a shape. It decides which of several hits is the closest
// where their rounded t are too close to compare. The file of each kind of shape in common/geometry
// declares its `exact_root`: the first root strictly inside the interval, which must contain one.
// The kind's stage defines it (steps/*/exact).
#pragma once

#include "common/exact/first_root.hpp"

namespace rt {

/// The first root of a shape strictly inside the interval, which must contain one.
template <class CrossingIn>
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Along<CrossingIn>& shape,
                                                  Interval interval) {
    const InUnits asked(ray, shape.length_unit, interval);
    const auto root = first_root(shape.crossing_in(Dyadic(), asked.ray), asked.interval).root;
    if (!root) return std::nullopt;
    ExactRoot exact{*root};
    const Dyadic time_unit = asked.time_unit;
    exact.rational = time_unit * exact.rational;
    exact.radicand = time_unit * time_unit * exact.radicand;
    return exact;
}

/// The sign of a − b; nothing if one of them is not a number.
[[nodiscard]] inline std::optional<int> order_of(const ExactRoot& a, const ExactRoot& b) {
    // The sign of p + q √d + r √e, multiplied by both denominators.
    const Dyadic p = a.rational * b.denominator - b.rational * a.denominator;
    const Dyadic q = Dyadic(Real(a.surd)) * b.denominator;
    const Dyadic r = Dyadic(Real(-b.surd)) * a.denominator;
    const Dyadic qqd = q * q * a.radicand;
    const Dyadic rre = r * r * b.radicand;
    const auto whole = p.sign();
    const auto larger = (qqd - rre).sign();
    if (!whole || !larger) return std::nullopt;
    int surds = a.surd != 0 ? a.surd : -b.surd;
    if (a.surd * b.surd > 0) surds = a.surd * *larger;
    if (*whole * surds >= 0) return *whole != 0 ? *whole : surds;
    const Dyadic qr = q * r;
    return *whole * sign_of_sum(p * p - qqd - rre, -(qr + qr), a.radicand * b.radicand).value();
}

}  // namespace rt
