// Stage 5 for `--precision exact`: every decision is that of exact arithmetic, t within 8 ulp.
#include "steps/step05_triangle/triangle.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/first_root.hpp"

namespace rt {
std::optional<Real> reference_intersect(const Ray&, const Triangle&, Interval);
}
#define intersect reference_intersect  // the rest of stage 5 is the reference's
#include "steps/step05_triangle/reference/triangle.cpp"
#undef intersect

namespace rt {

namespace {

/// The plane's ⟨n, p − a⟩ = 0 along the ray, where α, β and γ have the sign of their sum.
[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Triangle& triangle,
                                                Interval interval) {
    const Vec3 size =
        glm::max(glm::abs(triangle.b - triangle.a),
                 glm::max(glm::abs(triangle.c - triangle.a), glm::abs(ray.origin - triangle.a)));
    const Real unit = power_of_two_below(largest_component(size));
    return decided(ray, unit, interval, [&]<class T>(T, const Ray& near) {
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
    });
}

/// Times the largest coordinates of the three, more than ⟨v, w × x⟩ may be off: six terms, each
/// rounded seven times on its way, with those of v, w and x themselves.
constexpr Real rounding = 48 * unit_roundoff;

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Triangle& triangle, Interval interval) {
    // Möller and Trumbore's determinants, whose signs are certain but for so much.
    const Vec3& d = ray.direction;
    const Vec3 ab = triangle.b - triangle.a;
    const Vec3 ac = triangle.c - triangle.a;
    const Rounded x = exact_sum(ray.origin.x, -triangle.a.x);
    const Rounded y = exact_sum(ray.origin.y, -triangle.a.y);
    const Rounded z = exact_sum(ray.origin.z, -triangle.a.z);
    const Vec3 s(x.value, y.value, z.value);
    const Vec3 q = cross(d, ac);
    const Vec3 r = cross(s, ab);
    const Real turned = dot(ab, q);
    const Real side = std::copysign(Real(1), turned);
    const Real whole = std::abs(turned);
    const Real beta = side * dot(s, q);
    const Real gamma = side * dot(d, r);
    const Real alpha = whole - beta - gamma;

    const Real size_ab = largest_component(ab);
    const Real size_ac = largest_component(ac);
    const Real size_d = rounding * largest_component(d);
    const Real size_s = largest_component(s);
    const Real whole_doubt = size_d * size_ab * size_ac + underflow;
    const Real beta_doubt = size_d * size_s * size_ac + underflow;
    const Real gamma_doubt = size_d * size_s * size_ab + underflow;
    const Real alpha_doubt = whole_doubt + beta_doubt + gamma_doubt;
    if (whole > whole_doubt && (alpha < -alpha_doubt || beta < -beta_doubt || gamma < -gamma_doubt))
        return std::nullopt;
    const bool inside =
        whole > 16 * whole_doubt && alpha > alpha_doubt && beta > beta_doubt && gamma > gamma_doubt;
    if (!inside) return carefully(ray, triangle, interval);

    // From the point p of the ray that is almost in the plane: what is left to go rounds in the
    // triangle's size, not in the distance of the origin.
    const Real t_near = side * dot(ac, r) / whole;
    const Vec3 p = fused_at(s, t_near, d) + Vec3(x.dropped, y.dropped, z.dropped);
    const Real from_near = side * dot(cross(ab, ac), p) / whole;
    const Real t = t_near + from_near;
    const Real doubt = Real(1.2) * rounding * size_ab * size_ac * largest_component(p) / whole +
                       std::abs(from_near) / 8;
    const Estimate root{.t = t, .error = doubt + 3 * unit_roundoff * std::abs(t)};
    if (root.before(interval) || root.after(interval)) return std::nullopt;
    if (!root.answers(interval, 64)) return carefully(ray, triangle, interval);
    return t;
}

}  // namespace rt
