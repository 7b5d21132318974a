// Stage 3 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 32 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step03_sphere/sphere.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The intersection ⟨p, p⟩ = r² along the ray.
auto along(const Sphere& sphere) {
    const Real unit = power_of_two_below(sphere.radius);
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto o = exactly<T>(near.origin) - exactly<T>(sphere.center / unit);
        const auto d = exactly<T>(near.direction);
        const T r = sphere.radius / unit;
        return Crossing<T, 0>{.a = dot(d, d), .b = dot(o, d), .c = dot(o, o) - r * r};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Sphere& sphere,
                                                Interval interval) {
    return decided(ray, along(sphere), interval);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Sphere& sphere, Interval interval) {
    // The reference's formula, relative to the point p of the line closest to the center, whose
    // error is at most u (2 |p| + w) (certain.hpp).
    const Vec3& d = ray.direction;
    const Rounded x = exact_sum(ray.origin.x, -sphere.center.x);
    const Rounded y = exact_sum(ray.origin.y, -sphere.center.y);
    const Rounded z = exact_sum(ray.origin.z, -sphere.center.z);
    const Vec3 from_center(x.value, y.value, z.value);
    const Real dd = dot(d, d);
    const Real inverse = 1 / dd;
    const Real t_near = -dot(from_center, d) * inverse;
    const Vec3 p = fused_at(from_center, t_near, d) + Vec3(x.dropped, y.dropped, z.dropped);

    // ⟨p, p⟩ has an error of at most 7.5 u ⟨p, p⟩ + 2 u w². `aside` corrects for p not being
    // exactly the closest point.
    const Real pp = dot(p, p);
    const Real ww = dd * (unit_roundoff * t_near) * (unit_roundoff * t_near);
    const Real aside = dot(p, d) * inverse;
    const Real half_chord_squared = std::fma(sphere.radius, sphere.radius, -pp);
    const Real doubt = 8 * unit_roundoff * (pp + ww) +
                       unit_roundoff * std::abs(half_chord_squared) + 2 * aside * dot(p, d);
    const bool tells = moderate(dd, dd) && moderate(sphere.radius, sphere.radius);
    if (half_chord_squared < -doubt && tells) return std::nullopt;
    if (!(half_chord_squared > 16 * doubt && tells)) return carefully(ray, sphere, interval);

    const Real half_chord = std::sqrt(half_chord_squared * inverse);
    // The error consists of half of the relative error of the square; 4.5 u for the division, the
    // root and the sum; and for `aside` 5 u |p| / |d|, which is at most 1.5 u of the share of p and
    // 4.5 u of half_chord.
    const Real share = Real(0.55) * doubt + Real(1.5) * unit_roundoff * pp;
    const Real error = half_chord * (share / half_chord_squared + 9 * unit_roundoff) +
                       6 * unit_roundoff * std::abs(aside);
    for (const Real from_near : {-half_chord, half_chord}) {
        const Real t = t_near + (from_near - aside);
        const Estimate root{.t = t, .error = error + 3 * unit_roundoff * std::abs(t)};
        if (root.before(interval)) continue;
        if (root.after(interval)) return std::nullopt;
        if (!root.answers(interval, 32)) return carefully(ray, sphere, interval);
        return t;
    }
    return std::nullopt;
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Sphere& sphere, Interval interval) {
    return exact_root(ray, along(sphere), interval);
}

}  // namespace rt
