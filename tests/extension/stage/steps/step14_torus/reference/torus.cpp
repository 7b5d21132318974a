#include "steps/step14_torus/torus.hpp"

#include "common/math/vector.hpp"

#include <vector>

namespace rt {

namespace {

/// c[0] + c[1] s + c[2] s² + …
using Polynomial = std::vector<Real>;

Real value(const Polynomial& c, Real s) {
    Real sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * s + c[i];
    return sum;
}

/// The roots from −reach to reach, in their order: between two neighboring roots of the derivative
/// is at most one, which is bisected.
std::vector<Real> roots(const Polynomial& c, Real reach) {
    if (c.size() < 2) return {};
    Polynomial slope;
    for (std::size_t i = 1; i < c.size(); ++i) slope.push_back(Real(i) * c[i]);
    std::vector<Real> ends = roots(slope, reach);
    ends.insert(ends.begin(), -reach);
    ends.push_back(reach);
    std::vector<Real> found;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        Real low = ends[i];
        Real high = ends[i + 1];
        const bool from_below = value(c, low) < 0;
        if (from_below == (value(c, high) < 0)) continue;
        for (int halving = 0; halving < 64; ++halving) {
            const Real middle = (low + high) / 2;
            ((value(c, middle) < 0) == from_below ? low : high) = middle;
        }
        found.push_back(high);
    }
    return found;
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Torus& torus, Interval interval) {
    // Relative to the point p of the line closest to the center, where ⟨p, d⟩ = 0.
    const Real speed = length(ray.direction);
    const Vec3 d = ray.direction / speed;
    const Vec3 from_center = ray.origin - torus.center;
    const Real to_closest = -dot(from_center, d);
    const Vec3 p = from_center + to_closest * d;
    const Real p_z = dot(p, torus.axis);
    const Real d_z = dot(d, torus.axis);
    const Real rr = 4 * torus.radius * torus.radius;
    const Real k = dot(p, p) + rr / 4 - torus.tube * torus.tube;
    const Polynomial quartic = {k * k - rr * (dot(p, p) - p_z * p_z), 2 * rr * p_z * d_z,
                                2 * k - rr * (1 - d_z * d_z), 0, 1};
    // A little farther than the torus reaches, so that no root is lost by rounding.
    for (const Real s : roots(quartic, Real(1.01) * (torus.radius + torus.tube))) {
        const Real t = (to_closest + s) / speed;
        if (interval.contains(t)) return t;
    }
    return std::nullopt;
}

Vec3 normal(const Torus& torus, Vec3 point) {
    return unit(point - nearest_of_circle(torus, point));
}

}  // namespace rt
