// Stage 8 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 128 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step08_cone/cone.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <array>
#include <cmath>

namespace rt {

namespace {

/// The intersection h² ‖p × Z‖² = r² ⟨p, Z⟩² along the ray, where 0 ≤ z and z² ≤ h² ‖Z‖²: ‖Z‖ is 1
/// up to rounding.
auto along(const Cone& cone) {
    const Real unit = power_of_two_below(glm::max(cone.radius, cone.height));
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto o = exactly<T>(near.origin) - exactly<T>(cone.apex / unit);
        const auto d = exactly<T>(near.direction);
        const auto axis = exactly<T>(cone.axis);
        const auto o_across = cross(o, axis);
        const auto d_across = cross(d, axis);
        const T o_along = dot(o, axis);
        const T d_along = dot(d, axis);
        const T r = cone.radius / unit;
        const T h = cone.height / unit;
        const T rr = r * r;
        const T hh = h * h;
        return Crossing<T, 2>{.a = hh * dot(d_across, d_across) - rr * d_along * d_along,
                              .b = hh * dot(o_across, d_across) - rr * o_along * d_along,
                              .c = hh * dot(o_across, o_across) - rr * o_along * o_along,
                              .conditions = {{{.c0 = o_along, .c1 = d_along},
                                              {.c0 = hh * dot(axis, axis) - o_along * o_along,
                                               .c1 = -(o_along + o_along) * d_along,
                                               .c2 = -d_along * d_along}}}};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Cone& cone,
                                                Interval interval) {
    return decided(ray, along(cone), interval);
}

/// A number with an upper bound on its error.
struct Bounded {
    Real value;
    Real error;

    /// Returns whether it is far enough from 0 to divide by it.
    [[nodiscard]] bool divides() const {
        return std::abs(value) > 16 * error && std::abs(value) < infinity;
    }
};

Bounded quotient(const Bounded& a, const Bounded& b) {
    const Real value = a.value / b.value;
    const Real error = Real(1.1) * (a.error + std::abs(value) * b.error) / std::abs(b.value);
    return {.value = value, .error = error + unit_roundoff * std::abs(value)};
}

/// across² − along², factored, for two lengths with errors of at most `error` each: the error is at
/// most twice that times their sum, plus three roundings.
Bounded difference_of_squares(Real across, Real along, Real error) {
    const Real sum = across + along;
    return {.value = (across - along) * sum, .error = Real(2.1) * error * sum + underflow};
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Cone& cone, Interval interval) {
    // The reference's formula, relative to the point p of the line closest to the apex
    // (certain.hpp).
    const Vec3& d = ray.direction;
    const Vec3& axis = cone.axis;
    const Rounded x = exact_sum(ray.origin.x, -cone.apex.x);
    const Rounded y = exact_sum(ray.origin.y, -cone.apex.y);
    const Rounded z = exact_sum(ray.origin.z, -cone.apex.z);
    const Vec3 from_apex(x.value, y.value, z.value);
    const Real dd = dot(d, d);
    const Real t_near = -dot(from_apex, d) / dd;
    const Vec3 p = fused_at(from_apex, t_near, d) + Vec3(x.dropped, y.dropped, z.dropped);
    const Real size_d = std::sqrt(dd);
    const Real size_p = std::sqrt(dot(p, p)) + unit_roundoff * std::abs(t_near) * size_d;
    const Real r = cone.radius;
    const Real h = cone.height;
    if (!moderate(glm::min(glm::min(size_d, size_p), glm::min(r, h)),
                  glm::max(size_d, glm::max(r, h))))
        return carefully(ray, cone, interval);

    // In units of u, including the rounding of the length and of its product with r or h: across
    // and along the axis, the errors are at most 12 |p| |d| and 9 |p| |d| for the moment m, 7 |d|
    // and 4 |d| for d, 9 |p| and 6 |p| for p, where |p| includes w. An axis that is not exactly a
    // unit vector does not change the discriminant's sign, and moves the root by at most 8.
    const Vec3 m = cross(p, d);
    const Real size = unit_roundoff * (r + h);
    const Bounded discriminant = difference_of_squares(
        r * length(cross(m, axis)), h * std::abs(dot(m, axis)), 13 * size * size_p * size_d);
    if (discriminant.value < -discriminant.error) return std::nullopt;
    if (!discriminant.divides()) return carefully(ray, cone, interval);

    const Vec3 p_across = cross(p, axis);
    const Vec3 d_across = cross(d, axis);
    const Real p_along = dot(p, axis);
    const Real d_along = dot(d, axis);
    const Bounded a =
        difference_of_squares(h * length(d_across), r * std::abs(d_along), 8 * size * size_d);
    const Bounded c =
        difference_of_squares(h * length(p_across), r * std::abs(p_along), 10 * size * size_p);
    const Real b = h * h * dot(p_across, d_across) - r * r * p_along * d_along;
    const Real root = h * std::sqrt(discriminant.value);
    const Real share = Real(0.55) * discriminant.error / discriminant.value + 12 * unit_roundoff;
    const Bounded q{.value = -(b + std::copysign(root, b)),
                    .error = 16 * size * (r + h) * size_p * size_d + root * share};
    if (!a.divides() || !q.divides()) return carefully(ray, cone, interval);

    std::array<Bounded, 2> roots = {quotient(q, a), quotient(c, q)};
    if (roots[1].value < roots[0].value) std::swap(roots[0], roots[1]);
    if (!(roots[1].value - roots[0].value > Real(1.1) * (roots[0].error + roots[1].error)))
        return carefully(ray, cone, interval);  // the order is uncertain
    for (const Bounded& from_p : roots) {
        const Real t = t_near + from_p.value;
        const Real error = from_p.error + 3 * unit_roundoff * std::abs(t);
        const Estimate hit{.t = t, .error = error};
        if (hit.before(interval)) continue;
        if (hit.after(interval)) return std::nullopt;
        const Real height = p_along + from_p.value * d_along;
        const Real doubt = 10 * unit_roundoff * (size_p + std::abs(from_p.value) * size_d + h) +
                           Real(1.1) * from_p.error * size_d + underflow;
        if (height < -doubt || height > h + doubt) continue;
        const bool on_cone = height > doubt && height < h - doubt;
        if (!on_cone || !hit.answers(interval, 128)) return carefully(ray, cone, interval);
        return t;
    }
    return std::nullopt;
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Cone& cone, Interval interval) {
    return exact_root(ray, along(cone), interval);
}

}  // namespace rt
