// Where exactly a ray meets a shape: what the nearest of several is decided by where their t are
// too close to tell.
#pragma once

#include "common/exact/first_root.hpp"
#include "common/shapes.hpp"

namespace rt {

/// The first root of a shape strictly inside the interval, in which there is one.
template <class CrossingIn>
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Along<CrossingIn>& shape,
                                                  Interval interval) {
    const InUnits asked(ray, shape.length_unit, interval);
    auto root = first_root(shape.crossing_in(Dyadic(), asked.ray), asked.interval).root;
    if (!root) return std::nullopt;
    const Dyadic time_unit = asked.time_unit;
    root->rational = time_unit * root->rational;
    root->radicand = time_unit * time_unit * root->radicand;
    return root;
}

/// The sign of a − b; nothing if a number is none.
[[nodiscard]] inline std::optional<int> order_of(const ExactRoot& a, const ExactRoot& b) {
    // p + q √d + r √e, times both denominators.
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

// Of each kind.

[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Sphere& sphere,
                                                  Interval interval);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Plane& plane,
                                                  Interval interval);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Triangle& triangle,
                                                  Interval interval);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Square& square,
                                                  Interval interval);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Cylinder& cylinder,
                                                  Interval interval);
[[nodiscard]] std::optional<ExactRoot> exact_root(const Ray& ray, const Cone& cone,
                                                  Interval interval);

}  // namespace rt
