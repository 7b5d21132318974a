// Stage 4 for `--precision exact`: every decision is that of exact arithmetic, t within 8 ulp.
#include "steps/step04_plane/plane.hpp"

#include "common/exact/certain.hpp"
#include "common/exact/first_root.hpp"

namespace rt {
std::optional<Real> reference_intersect(const Ray&, const Plane&, Interval);
}
#define intersect reference_intersect  // the rest of stage 4 is the reference's
#include "steps/step04_plane/reference/plane.cpp"
#undef intersect

namespace rt {

namespace {

/// ⟨n, p − a⟩ = 0 along the ray.
[[gnu::noinline]] std::optional<Real> carefully(const Ray& ray, const Plane& plane,
                                                Interval interval) {
    const Real unit =
        power_of_two_below(glm::max(largest_component(ray.origin), largest_component(plane.point)));
    const Vec3 unit_normal = plane.normal / power_of_two_below(largest_component(plane.normal));
    return decided(ray, unit, interval, [&]<class T>(T, const Ray& near) {
        const auto n = exactly<T>(unit_normal);
        const auto o = exactly<T>(near.origin) - exactly<T>(plane.point / unit);
        return Crossing<T, 0>{.b = T(Real(0.5)) * dot(exactly<T>(near.direction), n),
                              .c = dot(o, n)};
    });
}

/// A scalar product, and how far it may be from the exact one.
struct Product {
    Real value;
    Real error;
};

/// x + y + z, of terms that are rounded so often.
Product sum_of(Vec3 terms, Real roundings) {
    const Real value = terms.x + terms.y + terms.z;
    const Real size = std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z);
    return {.value = value, .error = unit_roundoff * ((roundings + 1) * size + std::abs(value))};
}

/// t = distance / approach, if it is no further than 24 u t from the exact one.
std::optional<Real> quotient(const Product& distance, const Product& approach) {
    constexpr Real most = 22 * unit_roundoff;  // a division is to come, and products of errors
    const Real t = distance.value / approach.value;
    const Real size = std::abs(approach.value);
    if (!(distance.error + std::abs(t) * approach.error + underflow <= most * std::abs(t) * size))
        return std::nullopt;
    return t;
}

/// ⟨n, v + dropped⟩ with twice the digits (Ogita, Rump, Oishi 2005, Dot2): then u of the result,
/// and a few u² of its terms, which were summed up before.
Product compensated(Vec3 n, Vec3 v, Vec3 dropped, const Product& before) {
    const Rounded x = exact_product(n.x, v.x);
    const Rounded y = exact_product(n.y, v.y);
    const Rounded z = exact_product(n.z, v.z);
    const Rounded xy = exact_sum(x.value, y.value);
    const Rounded xyz = exact_sum(xy.value, z.value);
    const Real rest = (xyz.dropped + xy.dropped) + (x.dropped + y.dropped + z.dropped);
    const Real value = xyz.value + (rest + dot(n, dropped));
    return {.value = value, .error = unit_roundoff * (std::abs(value) + 32 * before.error)};
}

}  // namespace

std::optional<Real> intersect(const Ray& ray, const Plane& plane, Interval interval) {
    const auto& [o, d] = ray;
    const auto& [point, n] = plane;
    const Product distance = sum_of(n * (point - o), 2);
    const Product approach = sum_of(n * d, 1);
    auto t = quotient(distance, approach);
    if (!t) {
        const Rounded x = exact_sum(point.x, -o.x);
        const Rounded y = exact_sum(point.y, -o.y);
        const Rounded z = exact_sum(point.z, -o.z);
        t = quotient(compensated(n, {x.value, y.value, z.value}, {x.dropped, y.dropped, z.dropped},
                                 distance),
                     compensated(n, d, Vec3(0), approach));
    }
    if (!t) return carefully(ray, plane, interval);
    const Estimate root{.t = *t, .error = 24 * unit_roundoff * std::abs(*t)};
    if (root.before(interval) || root.after(interval)) return std::nullopt;
    if (!root.answers(interval, 24)) return carefully(ray, plane, interval);
    return t;
}

}  // namespace rt
