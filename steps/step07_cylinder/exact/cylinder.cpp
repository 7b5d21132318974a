// Stage 7 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 64 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step07_cylinder/cylinder.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The intersection ‖p × Z‖² = r² ‖Z‖² along the ray, where z² ≤ (h / 2)² ‖Z‖²: ‖Z‖ is 1 up to
/// rounding.
auto along(const Cylinder& cylinder) {
    const Real unit = power_of_two_below(glm::max(cylinder.radius, cylinder.height));
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto o = exactly<T>(near.origin) - exactly<T>(cylinder.center / unit);
        const auto d = exactly<T>(near.direction);
        const auto axis = exactly<T>(cylinder.axis);
        const auto o_across = cross(o, axis);
        const auto d_across = cross(d, axis);
        const T o_along = dot(o, axis);
        const T d_along = dot(d, axis);
        const T radius = cylinder.radius / unit;
        const T half = cylinder.height / unit / 2;
        const T square = dot(axis, axis);
        return Crossing<T, 1>{.a = dot(d_across, d_across),
                              .b = dot(o_across, d_across),
                              .c = dot(o_across, o_across) - square * radius * radius,
                              .conditions = {{{.c0 = square * half * half - o_along * o_along,
                                               .c1 = -(o_along + o_along) * d_along,
                                               .c2 = -d_along * d_along}}}};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Cylinder& cylinder,
                                                Interval interval) {
    return decided(ray, along(cylinder), interval);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    // The reference's formula, relative to the point p of the line closest to the center
    // (certain.hpp), in the cross-section.
    const Vec3& d = ray.direction;
    const Vec3& axis = cylinder.axis;
    const Rounded x = exact_sum(ray.origin.x, -cylinder.center.x);
    const Rounded y = exact_sum(ray.origin.y, -cylinder.center.y);
    const Rounded z = exact_sum(ray.origin.z, -cylinder.center.z);
    const Vec3 from_center(x.value, y.value, z.value);
    const Real dd = dot(d, d);
    const Real t_near = -dot(from_center, d) / dd;
    const Vec3 p = fused_at(from_center, t_near, d) + Vec3(x.dropped, y.dropped, z.dropped);
    const Vec3 p_across = cross(p, axis);
    const Vec3 d_across = cross(d, axis);
    const Real a = dot(d_across, d_across);
    const Real t_closest = -dot(p_across, d_across) / a;
    const Vec3 closest = p_across + t_closest * d_across;
    const Real cc = dot(closest, closest);
    const Real rr = cylinder.radius * cylinder.radius;

    // In units of u: across the axis, the error of p is at most 5 (|p| + w) and that of d 3 |d|,
    // which rotates d by more the closer the ray is to parallel with the axis: by the factor
    // `along`. So the distance of `closest` from the line's point at t_closest is at most (|p| + w)
    // (7 + 3 along), and that point is (|p| + w) (12 + 9 along) from the closest point. The error
    // of the square is the first times twice its length, which is at most (cc + r²) / r, plus the
    // squares of both, plus 16 r² for an axis that is not exactly a unit vector.
    const Real size_d = std::sqrt(dd);
    const Real along = size_d / std::sqrt(a);
    const Real size_p =
        unit_roundoff * (std::sqrt(dot(p, p)) + unit_roundoff * std::abs(t_near) * size_d);
    const Real aside = size_p * (14 + 10 * along);
    const Real half_chord_squared = rr - cc;
    const Real doubt =
        (size_p * (7 + 3 * along) / cylinder.radius + 24 * unit_roundoff) * (cc + rr) +
        aside * aside;
    const bool tells =
        along < Real(0x1p45) &&  // otherwise the rounding error of the axis might matter
        moderate(glm::min(size_d, cylinder.radius), glm::max(size_d, cylinder.radius));
    if (tells && half_chord_squared < -doubt) return std::nullopt;
    if (!(tells && half_chord_squared > 16 * doubt)) return carefully(ray, cylinder, interval);

    const Real half_chord = std::sqrt(half_chord_squared / a);
    const Real share = Real(0.55) * doubt / half_chord_squared + unit_roundoff * (3 * along + 6);
    const Real error = half_chord * share + aside / std::sqrt(a);
    const Real p_along = dot(p, axis);
    const Real d_along = dot(d, axis);
    for (const Real from_p : {t_closest - half_chord, t_closest + half_chord}) {
        const Real t = t_near + from_p;
        const Estimate root{.t = t, .error = error + 3 * unit_roundoff * std::abs(t)};
        if (root.before(interval)) continue;
        if (root.after(interval)) return std::nullopt;
        const Real beyond = std::abs(p_along + from_p * d_along) - cylinder.height / 2;
        const Real z_doubt = 8 * size_p + 8 * unit_roundoff * cylinder.height +
                             size_d * (8 * unit_roundoff * std::abs(from_p) + Real(1.1) * error) +
                             underflow;
        if (beyond > z_doubt) continue;
        if (!(beyond < -z_doubt) || !root.answers(interval, 64))
            return carefully(ray, cylinder, interval);
        return t;
    }
    return std::nullopt;
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Cylinder& cylinder, Interval interval) {
    return exact_root(ray, along(cylinder), interval);
}

}  // namespace rt
