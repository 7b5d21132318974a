// Stage 5 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 64 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step05_triangle/triangle.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The intersection with the plane, ⟨n, p − a⟩ = 0 along the ray, where α, β and γ have the sign of
/// their sum.
auto along(const Ray& ray, const Triangle& triangle) {
    const Vec3 size =
        glm::max(glm::abs(triangle.b - triangle.a),
                 glm::max(glm::abs(triangle.c - triangle.a), glm::abs(ray.origin - triangle.a)));
    const Real unit = power_of_two_below(largest_component(size));
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto corner = exactly<T>(triangle.a / unit);
        const auto ab = exactly<T>(triangle.b / unit) - corner;
        const auto ac = exactly<T>(triangle.c / unit) - corner;
        const auto s = exactly<T>(near.origin) - corner;
        const auto d = exactly<T>(near.direction);
        const auto n = cross(ab, ac);
        const T whole = -dot(n, d);
        const T beta = dot(s, cross(d, ac));
        const T gamma = dot(d, cross(s, ab));
        return Crossing<T, 3>{.b = T(Real(-0.5)) * whole,
                              .c = dot(s, n),
                              .conditions = {{{.c0 = whole * beta},
                                              {.c0 = whole * gamma},
                                              {.c0 = whole * (whole - beta - gamma)}}}};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Triangle& triangle,
                                                Interval interval) {
    return decided(ray, along(ray, triangle), interval);
}

/// Times the largest coordinates of v, w and x, an upper bound on the error of ⟨v, w × x⟩: six
/// terms, each rounded seven times, including the roundings of v, w and x, and twice more in α.
constexpr Real rounding = 56 * unit_roundoff;

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    // Möller and Trumbore's determinants, whose signs are certain up to these error bounds.
    const Vec3& o = ray.origin;
    const Vec3& d = ray.direction;
    const Vec3& corner = triangle.a;
    const Vec3 ab = triangle.b - corner;
    const Vec3 ac = triangle.c - corner;
    const Vec3 s = o - corner;
    const Vec3 q = cross(d, ac);
    const Vec3 r = cross(s, ab);
    const Real determinant = dot(ab, q);
    const Real side = std::copysign(Real(1), determinant);
    const Real whole = std::abs(determinant);
    const Real beta = side * dot(s, q);
    const Real gamma = side * dot(d, r);
    const Real least = glm::min(whole - beta - gamma, glm::min(beta, gamma));

    const Real size_ab = largest_component(ab);
    const Real size_ac = largest_component(ac);
    const Real size_d = largest_component(d);
    const Real whole_doubt = rounding * size_d * size_ab * size_ac;
    const Real doubt = whole_doubt + rounding * size_d * largest_component(s) * (size_ab + size_ac);
    const bool tells = moderate(glm::min(size_d, glm::min(size_ab, size_ac)),
                                glm::max(size_d, glm::max(size_ab, size_ac))) &&
                       least - whole > -infinity;  // so none of the three is NaN or infinite
    if (tells && least < -doubt && whole > whole_doubt) return std::nullopt;
    const bool inside = tells && least > doubt && whole > 16 * whole_doubt;
    if (!inside) return carefully(ray, triangle, interval);

    // The computation is relative to the point p of the ray that is almost in the plane
    // (certain.hpp): the remaining errors depend on the triangle's size and not on the distance of
    // the origin.
    const Vec3 dropped(
        exact_sum(o.x, -corner.x).dropped, exact_sum(o.y, -corner.y).dropped,
        exact_sum(o.z, -corner.z).dropped);  // the rounding error of s; a miss does not need it
    const Real t_near = side * dot(ac, r) / whole;
    const Vec3 p = fused_at(s, t_near, d) + dropped;
    const Real from_near = side * dot(cross(ab, ac), p) / whole;
    const Real t = t_near + from_near;
    const Real size_p = largest_component(p) + unit_roundoff * std::abs(t_near) * size_d;
    const Real error = Real(1.2) * rounding * size_ab * size_ac * size_p / whole +
                       std::abs(from_near) / 8 + 3 * unit_roundoff * std::abs(t);
    const Estimate root{.t = t, .error = error};
    if (root.before(interval) || root.after(interval)) return std::nullopt;
    if (!root.answers(interval, 64)) return carefully(ray, triangle, interval);
    return t;
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Triangle& triangle, Interval interval) {
    return exact_root(ray, along(ray, triangle), interval);
}

}  // namespace rt
