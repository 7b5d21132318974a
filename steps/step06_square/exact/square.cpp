// Stage 6 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 32 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step06_square/square.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The intersection z = 0 along the ray, where |x| and |y| ≤ side / 2 and, for a one-sided square,
/// z decreases.
auto along(const Square& square) {
    const Real unit = power_of_two_below(square.side);
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto o = exactly<T>(near.origin) - exactly<T>(square.center / unit);
        const auto d = exactly<T>(near.direction);
        const auto x = exactly<T>(square.basis.x);
        const auto y = exactly<T>(square.basis.y);
        const auto z = exactly<T>(square.basis.z);
        const T half = square.side / unit / 2;
        const T slope = dot(d, z);
        return Crossing<T, 5>{.b = T(Real(0.5)) * slope,
                              .c = dot(o, z),
                              .conditions = {{{.c0 = half - dot(o, x), .c1 = -dot(d, x)},
                                              {.c0 = half + dot(o, x), .c1 = dot(d, x)},
                                              {.c0 = half - dot(o, y), .c1 = -dot(d, y)},
                                              {.c0 = half + dot(o, y), .c1 = dot(d, y)},
                                              {.c0 = square.one_sided ? -slope : T(Real(0))}}}};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Square& square,
                                                Interval interval) {
    return decided(ray, along(square), interval);
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Square& square, Interval interval) {
    // The reference's formula, relative to the point p of the ray that is almost in the plane
    // (certain.hpp): the error of ⟨p, x⟩ is at most 9 u times p's largest coordinate and w, that of
    // ⟨d, x⟩ 6 u times d's.
    const auto& [x, y, z] = square.basis;
    const Vec3& d = ray.direction;
    const Rounded o_x = exact_sum(ray.origin.x, -square.center.x);
    const Rounded o_y = exact_sum(ray.origin.y, -square.center.y);
    const Rounded o_z = exact_sum(ray.origin.z, -square.center.z);
    const Vec3 o(o_x.value, o_y.value, o_z.value);
    const Real slope = dot(d, z);
    const Real t_near = -dot(o, z) / slope;
    const Vec3 p = fused_at(o, t_near, d) + Vec3(o_x.dropped, o_y.dropped, o_z.dropped);
    const Real height = dot(p, z);
    const Real steepness = std::abs(slope);
    const Real size_d = largest_component(d);
    const Real size_p = largest_component(p) + unit_roundoff * std::abs(t_near) * size_d;
    const bool tells = moderate(glm::min(size_d, square.side), glm::max(size_d, square.side)) &&
                       steepness > 64 * unit_roundoff * size_d;
    if (!tells) return carefully(ray, square, interval);
    if (square.one_sided && slope > 0) return std::nullopt;

    const Real limit = square.side / 2 * steepness;
    const Real doubt = unit_roundoff * size_d * (64 * size_p + 4 * square.side);
    const Real x_beside = std::abs(dot(p, x) * slope - height * dot(d, x)) - limit;
    const Real y_beside = std::abs(dot(p, y) * slope - height * dot(d, y)) - limit;
    if (x_beside > doubt || y_beside > doubt) return std::nullopt;
    const bool inside = x_beside < -doubt && y_beside < -doubt;
    if (!inside) return carefully(ray, square, interval);

    const Real from_near = height / slope;
    const Real t = t_near - from_near;
    const Real error = unit_roundoff * (10 * size_p / steepness + 3 * std::abs(t)) +
                       std::abs(from_near) / 8 + underflow;
    const Estimate root{.t = t, .error = error};
    if (root.before(interval) || root.after(interval)) return std::nullopt;
    if (!root.answers(interval, 32)) return carefully(ray, square, interval);
    return t;
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Square& square, Interval interval) {
    return exact_root(ray, along(square), interval);
}

}  // namespace rt
