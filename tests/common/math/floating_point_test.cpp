// The build's guarantees about numbers: every operation is rounded once, in the order of the
// source, and NaN, infinities, signed zeros and subnormal numbers follow IEEE 754.
// common/math/compensated.hpp and the watertight triangle depend on it;
// common/cmake/compile_options.cmake contains the flags. The tests fail with -ffast-math, and with
// -ffp-contract=fast if the processor has fma.
#include "common/math/compensated.hpp"
#include "common/math/vector.hpp"
#include "steps/step05_triangle/triangle.hpp"

#include "tests/kit/for_all.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

using namespace rt;

namespace {

using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
using Limits = std::numeric_limits<Real>;

/// The same number, unknown to the compiler.
Real opaque(Real value) {
    volatile Real hidden = value;
    return hidden;
}

/// A test of the bits, since -ffast-math makes isnan() constant false.
bool is_nan(Real value) {
    const Bits size = std::bit_cast<Bits>(value) & ~std::bit_cast<Bits>(Real(-0.0));
    return size > std::bit_cast<Bits>(infinity);
}

bool is_negative(Real value) {
    return (std::bit_cast<Bits>(value) & std::bit_cast<Bits>(Real(-0.0))) != 0;
}

/// x y + z, as any code here writes it.
Real sum_of_product(Real x, Real y, Real z) {
    return x * y + z;
}

/// The triangle with its corners in turn at a, b and c.
std::array<Triangle, 3> in_all_roles(const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    return {Triangle{a, b, c}, Triangle{b, c, a}, Triangle{c, a, b}};
}

bool is_hit(const Ray& ray, const Triangle& triangle) {
    return intersect(ray, triangle, {}).has_value();
}

}  // namespace

TEST_CASE("a product is rounded before it is added to: nothing is contracted") {
    // (1 + 2u)² is 1 + 4u plus a small term, which is rounded away. Each use computes it again: the
    // compiler might fuse a product with one use only.
    const auto more = [] { return opaque(1 + 2 * unit_roundoff); };
    const auto square = [] { return opaque(1 + 4 * unit_roundoff); };
    CHECK(sum_of_product(more(), more(), -square()) == 0);
    CHECK(dot(Vec3(more(), 1, 0), Vec3(more(), -square(), 0)) == 0);
    CHECK(cross(Vec3(more(), square(), 0), Vec3(opaque(1), more(), 0)).z == 0);
    // An explicit fma is not rounded in between.
    CHECK(std::fma(more(), more(), -square()) == 4 * unit_roundoff * unit_roundoff);
}

TEST_CASE("sums are taken as they are written: nothing is reassociated") {
    const Real one = opaque(1);
    const Real little = opaque(unit_roundoff / 2);
    CHECK((one + little) - one == 0);
    CHECK(((one + little) + little) + little == 1);
    CHECK(exact_sum(one, little).dropped == little);
    CHECK(exact_sum(little, one).dropped == little);
    Real sum = one;
    for (int i = 0; i < 64; ++i) sum += opaque(unit_roundoff / 2);
    CHECK(sum == 1);
    // A division is not replaced by a multiplication by the inverse: 49 (1 / 49) is not 1.
    const std::array<Real, 4> odd = {opaque(49), opaque(98), opaque(103), opaque(107)};
    const Real divisor = opaque(49);
    CHECK(odd[0] / divisor == 1);
    CHECK(odd[1] / divisor == 2);
    int alike = 0;
    for (int i = 1; i < 1000; ++i) alike += opaque(Real(i)) / opaque(Real(i)) == 1;
    CHECK(alike == 999);
}

TEST_CASE("NaN and infinities are themselves") {
    const Real zero = opaque(0);
    CHECK(is_nan(zero / zero));
    CHECK(is_nan(opaque(infinity) - opaque(infinity)));
    CHECK(is_nan(zero * opaque(infinity)));
    CHECK(opaque(1) / zero == infinity);
    CHECK(opaque(Limits::max()) * opaque(2) == infinity);
    // Comparisons that must fail on NaN fail: this makes a ray miss a shape that is not a number.
    const Real nan = opaque(Limits::quiet_NaN());
    CHECK_FALSE(nan >= 0);
    CHECK_FALSE(nan < 0);
    CHECK_FALSE(nan == nan);
    CHECK(!(nan >= 0));
    CHECK_FALSE(Interval{}.contains(nan));
    CHECK_FALSE(Interval{}.contains(opaque(infinity)));
}

TEST_CASE("zeros have signs") {
    const Real zero = opaque(0);
    CHECK(is_negative(-zero));
    CHECK(is_negative(zero * opaque(-1)));
    CHECK_FALSE(is_negative(-zero + zero));
    CHECK(opaque(1) / -zero == -infinity);
    CHECK(zero == -zero);
}

TEST_CASE("subnormal numbers are not flushed to zero") {
    const Real smallest = opaque(Limits::denorm_min());
    CHECK(smallest > 0);
    CHECK(smallest + smallest == 2 * Limits::denorm_min());
    CHECK(opaque(Limits::min()) / 2 > 0);
    CHECK(opaque(Limits::min()) - opaque(Limits::min()) * opaque(Real(0.75)) == Limits::min() / 4);
    CHECK(smallest / smallest == 1);
}

TEST_CASE("square roots and divisions are the nearest numbers") {
    CHECK(for_all(
        [](Random& random) {
            const Real x = random.between(1, 2);
            const Real root = std::sqrt(opaque(x));
            // |root² − x| ≤ u root: with its rounding kept, the square is exact.
            const Rounded square = exact_product(root, root);
            const Real off = (square.value - x) + square.dropped;
            const Real third = x / opaque(3);
            const Rounded thrice = exact_product(third, 3);
            const Real off_third = (thrice.value - x) + thrice.dropped;
            return verdict(std::abs(off) <= 2 * unit_roundoff * root &&
                               std::abs(off_third) <= Real(1.5) * unit_roundoff,
                           "of " + text(x) + ": " + text(root) + ", " + text(third));
        },
        10'000));
}

TEST_CASE("a corner is seen at the same place in all three roles, and by both neighbors") {
    // A ray is aimed at the edge from p to q, and tested against the triangles on its two sides, in
    // all rotations. The position of a corner, relative to the ray, depends only on the corner and
    // the ray: so each triangle gives a consistent answer in all roles, and at least one is hit.
    CHECK(for_all(
        [](Random& random) {
            const Vec3 p = random.point(2);
            const Vec3 q = p + random.direction();
            const Vec3 aim = p + random.between(Real(0.1), Real(0.9)) * (q - p);
            const Vec3 origin = aim + random.between(1, 4) * random.direction();
            const Ray ray{.origin = origin, .direction = aim - origin};
            const Vec3 side = unit(cross(q - p, ray.direction));
            const Triangle left{p, q, aim + side};
            const Triangle right{q, p, aim - side};
            const bool hits_left = is_hit(ray, left);
            const bool hits_right = is_hit(ray, right);
            for (const Triangle& rotated : in_all_roles(left))
                if (is_hit(ray, rotated) != hits_left)
                    return verdict(false, code(ray) + ", " + code(left) + " turned");
            for (const Triangle& rotated : in_all_roles(right))
                if (is_hit(ray, rotated) != hits_right)
                    return verdict(false, code(ray) + ", " + code(right) + " turned");
            return verdict(hits_left || hits_right,
                           code(ray) + " hits neither " + code(left) + " nor " + code(right));
        },
        100'000));
}
