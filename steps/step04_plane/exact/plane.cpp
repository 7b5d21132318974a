// Stage 4 for `--precision exact`: every decision equals that of exact arithmetic, and t is proven
// to be within 16 u of the exact value. docs/reference/stability.md has the number types and the
// largest error found.
#include "steps/step04_plane/plane.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/exact_root.hpp"
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace rt {

namespace {

/// The intersection ⟨n, p − a⟩ = 0 along the ray.
auto along(const Ray& ray, const Plane& plane) {
    const Real unit =
        power_of_two_below(glm::max(largest_component(ray.origin), largest_component(plane.point)));
    const Vec3 unit_normal = plane.normal / power_of_two_below(largest_component(plane.normal));
    const auto crossing_in = [=]<class T>(T, const Ray& near) {
        const auto n = exactly<T>(unit_normal);
        const auto o = exactly<T>(near.origin) - exactly<T>(plane.point / unit);
        return Crossing<T, 0>{.b = T(Real(0.5)) * dot(exactly<T>(near.direction), n),
                              .c = dot(o, n)};
    };
    return Along{unit, crossing_in};
}

[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Plane& plane,
                                                Interval interval) {
    return decided(ray, along(ray, plane), interval);
}

/// A dot product, and the sum of the magnitudes of its terms.
struct Product {
    Real value;
    Real size;

    /// Returns whether there is so little cancellation that the relative error is at most 2 u.
    [[nodiscard]] bool certain() const {
        return std::abs(value) > 32 * unit_roundoff * size + underflow;
    }
};

/// ⟨n, v + dropped⟩ in twice the precision (Ogita, Rump, Oishi 2005, Dot2): the error is at most u
/// times the result plus 24 u² times the terms' magnitudes.
Product compensated_product(Vec3 n, Vec3 v, Vec3 dropped) {
    const Rounded x = exact_product(n.x, v.x);
    const Rounded y = exact_product(n.y, v.y);
    const Rounded z = exact_product(n.z, v.z);
    const Rounded xy = exact_sum(x.value, y.value);
    const Rounded xyz = exact_sum(xy.value, z.value);
    const Real rest = (xyz.dropped + xy.dropped) + (x.dropped + y.dropped + z.dropped);
    return {.value = xyz.value + (rest + dot(n, dropped)),
            .size = std::abs(x.value) + std::abs(y.value) + std::abs(z.value)};
}

/// For rays whose plain products cancel too much.
[[gnu::noinline]] std::optional<Real> compensated(const Ray& ray, const Plane& plane,
                                                  Interval interval) {
    const auto& [o, d] = ray;
    const auto& [point, n] = plane;
    const Rounded x = exact_sum(point.x, -o.x);
    const Rounded y = exact_sum(point.y, -o.y);
    const Rounded z = exact_sum(point.z, -o.z);
    const Product distance =
        compensated_product(n, {x.value, y.value, z.value}, {x.dropped, y.dropped, z.dropped});
    const Product approach = compensated_product(n, d, Vec3(0));
    if (!distance.certain() || !approach.certain()) return carefully(ray, plane, interval);
    const Real t = distance.value / approach.value;
    const Estimate root{.t = t, .error = 6 * unit_roundoff * std::abs(t)};
    if (root.before(interval) || root.after(interval)) return std::nullopt;
    if (!root.answers(interval, 6)) return carefully(ray, plane, interval);
    return t;
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    // MRT §4's quotient. With fma, the error of a dot product is at most u times the result and
    // each partial sum, and u times the terms in which a factor is a rounded difference.
    const Vec3& d = ray.direction;
    const Vec3& n = plane.normal;
    const Vec3 way = plane.point - ray.origin;
    const Real approach_z = n.z * d.z;
    const Real approach_yz = std::fma(n.y, d.y, approach_z);
    const Real approach = std::fma(n.x, d.x, approach_yz);
    const Real distance_z = n.z * way.z;
    const Real distance_yz = std::fma(n.y, way.y, distance_z);
    const Real distance = std::fma(n.x, way.x, distance_yz);
    const Real t = distance / approach;

    const Real terms = std::abs(n.x * way.x) + std::abs(n.y * way.y) + std::abs(distance_z);
    const Real distance_doubt = terms + std::abs(distance_z) + std::abs(distance_yz) + underflow;
    const Real approach_doubt = std::abs(approach_z) + std::abs(approach_yz) + underflow;
    // 12 u times t, plus 3 u for both products and their quotient. The comparison fails for
    // infinity.
    const Real doubt = std::fma(std::abs(t), approach_doubt, distance_doubt);
    const bool certain = doubt < 12 * std::abs(distance);
    const Estimate root{.t = t, .error = 16 * unit_roundoff * std::abs(t)};
    if (root.inside(interval) && certain) return t;
    if (certain && (root.before(interval) || root.after(interval))) return std::nullopt;
    return compensated(ray, plane, interval);
}

std::optional<ExactRoot> exact_root(const Ray& ray, const Plane& plane, Interval interval) {
    return exact_root(ray, along(ray, plane), interval);
}

}  // namespace rt
