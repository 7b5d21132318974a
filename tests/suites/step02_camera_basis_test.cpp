// Stage 2 against MRT §2 and M1.
#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"

#include "common/math/vector.hpp"

#include "tests/kit/exact.hpp"
#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>

using namespace rt;

namespace {

/// The contract's bound on each component.
constexpr Real bound = 10 * unit_roundoff;

using Exact3 = glm::vec<3, Exact>;

/// MRT §2 in wider arithmetic; for a vertical direction, X = (1, 0, 0).
struct ExactBasis {
    Exact3 x;
    Exact3 y;
    Exact3 z;
};

ExactBasis exact_basis(Vec3 towards) {
    const auto length = [](Exact3 v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); };
    const Exact3 z = Exact3(towards) / length(Exact3(towards));
    const bool vertical = towards.x == 0 && towards.z == 0;
    const Exact across = std::sqrt(z.x * z.x + z.z * z.z);
    const Exact3 x = vertical ? Exact3(1, 0, 0) : Exact3(z.z / across, 0, -z.x / across);
    const Exact3 y(z.y * x.z, z.z * x.x - z.x * x.z, -z.y * x.x);
    return {x, y, z};
}

/// The rounding of an exact component, the result of at most ten operations without cancellation.
constexpr Exact rounding = 5 * std::numeric_limits<Exact>::epsilon();

bool within_bound(Vec3 got, Exact3 expected) {
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(Exact(got[i]) - expected[i]) <= Exact(bound) + rounding)) return false;
    return true;
}

Verdict basis_is_exact(Vec3 towards) {
    const Basis got = orthonormal_basis(towards);
    const auto [x, y, z] = exact_basis(towards);
    return verdict(within_bound(got.x, x) && within_bound(got.y, y) && within_bound(got.z, z),
                   "orthonormal_basis(" + code(towards) +
                       "), each component within 10 u\n  got:      " + code(got) +
                       "\n  expected: " + code(Basis{.x = Vec3(x), .y = Vec3(y), .z = Vec3(z)}));
}

Verdict basis_is(Vec3 direction, const Basis& expected) {
    const Basis got = camera_basis(direction);
    return verdict(close(got.x, expected.x) && close(got.y, expected.y) && close(got.z, expected.z),
                   "camera_basis(" + code(direction) + ")\n  got:      " + code(got) +
                       "\n  expected: " + code(expected));
}

/// For a direction whose length has no square in this precision.
Verdict extreme_basis_is(Vec3 direction, const Basis& expected) {
    Verdict answer = basis_is(direction, expected);
    if (!answer)
        answer.sentence +=
            "\n  Do you square the length, as GLM's normalize and length do? This square is 0 or ∞:"
            "\n  unit(v) normalizes a vector of any length.";
    return answer;
}

/// Far from the vertical or near it, of any length.
Vec3 draw_direction(Random& random) {
    Vec3 v = random.direction();
    if (random.coin()) v.y = random.coin() ? 1 : -1;
    const Real lean = std::ldexp(Real(1), -random.below(60));
    v.x *= lean;
    v.z *= lean;
    return random.power_of_two() * v;
}

}  // namespace

TEST_CASE("the default camera has the world's axes (MRT §2)",
          "[part orthonormal_basis, camera_basis]") {
    CHECK(basis_is({0, 0, -1}, {.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}}));
}

TEST_CASE("level views to the right, back and to the left (MRT §2)", "[3 points]") {
    CHECK(basis_is({1, 0, 0}, {.x = {0, 0, 1}, .y = {0, 1, 0}, .z = {-1, 0, 0}}));
    CHECK(basis_is({0, 0, 1}, {.x = {-1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, -1}}));
    CHECK(basis_is({-1, 0, 0}, {.x = {0, 0, -1}, .y = {0, 1, 0}, .z = {1, 0, 0}}));
}

TEST_CASE("views that are pitched down and up: X, Y and Z have unit length (erratum 3, MRT §2)") {
    // (0, 1, 0) ∧ Z has the length 0.8 here, and 0.5 at a pitch of 60°.
    CHECK(basis_is(
        {0, -3, -4},
        {.x = {1, 0, 0}, .y = {0, Real(0.8), Real(-0.6)}, .z = {0, Real(0.6), Real(0.8)}}));
    const Real sine = std::sqrt(Real(0.75));
    CHECK(basis_is({0, sine, Real(-0.5)},
                   {.x = {1, 0, 0}, .y = {0, Real(0.5), sine}, .z = {0, -sine, Real(0.5)}}));
}

TEST_CASE("the direction has any length but zero (MRT §2)") {
    CHECK(basis_is({0, 0, -7}, {.x = {1, 0, 0}, .y = {0, 1, 0}, .z = {0, 0, 1}}));
    // So short that the square is 0, so long that it is ∞.
    for (const Real length : {std::numeric_limits<Real>::min(), std::numeric_limits<Real>::max()})
        CHECK(extreme_basis_is({length, 0, 0}, {.x = {0, 0, 1}, .y = {0, 1, 0}, .z = {-1, 0, 0}}));
}

TEST_CASE("a vertical view takes X = (1, 0, 0) (MRT §2)") {
    CHECK(basis_is({0, 1, 0}, {.x = {1, 0, 0}, .y = {0, 0, 1}, .z = {0, -1, 0}}));
    CHECK(basis_is({0, -1, 0}, {.x = {1, 0, 0}, .y = {0, 0, -1}, .z = {0, 1, 0}}));
    CHECK(basis_is({0, Real(-0.125), 0}, {.x = {1, 0, 0}, .y = {0, 0, -1}, .z = {0, 1, 0}}));
}

TEST_CASE("views almost along the vertical, to 2^-60 (MRT §2)", "[exact]") {
    const Real lean = std::ldexp(Real(1), -60);
    CHECK(basis_is_exact({lean, 1, 0}));
    CHECK(basis_is_exact({-lean, 1, 0}));
    CHECK(basis_is_exact({0, -1, lean}));
    CHECK(basis_is_exact({3 * lean, -1, 4 * lean}));
    CHECK(for_all([lean](Random& random) {
        const Vec3 aside = random.direction();
        return basis_is_exact({lean * aside.x, random.coin() ? 1 : -1, lean * aside.z});
    }));
}

TEST_CASE("each component is within 10 u of the exact one (contract)") {
    CHECK(for_all([](Random& random) { return basis_is_exact(draw_direction(random)); }, 2000));
}

TEST_CASE("the camera's basis is that around the opposite direction (MRT §2, Z = -c)") {
    CHECK(basis_is(
        {Real(0.6), 0, Real(-0.8)},
        {.x = {Real(0.8), 0, Real(0.6)}, .y = {0, 1, 0}, .z = {Real(-0.6), 0, Real(0.8)}}));
    CHECK(for_all([](Random& random) {
        const Vec3 direction = draw_direction(random);
        const auto& [x, y, z] = orthonormal_basis(-direction);
        return basis_is(direction, {.x = x, .y = y, .z = z});
    }));
}

TEST_CASE("a ray of the camera's frame is carried into the world (MRT §2)", "[part to_world]") {
    const Basis pitched{
        .x = {1, 0, 0}, .y = {0, Real(0.8), Real(-0.6)}, .z = {0, Real(0.6), Real(0.8)}};
    const Ray ray = to_world({.origin = {0, 0, 0}, .direction = {2, 5, -10}}, pitched, {7, 8, 9});
    const std::string asked = "to_world({.origin = {0, 0, 0}, .direction = {2, 5, -10}}, " +
                              code(pitched) + ", {7, 8, 9})";
    CHECK(gives(asked + ".origin", ray.origin, Vec3(7, 8, 9)));
    CHECK(gives(asked + ".direction", ray.direction, Vec3(2, -2, -11)));
    const Ray other = to_world({.origin = {1, 5, 10}, .direction = {0, 0, -1}}, pitched, {7, 8, 9});
    CHECK(gives("the same .origin for the ray's origin {1, 5, 10}", other.origin, Vec3(8, 18, 14)));
    const Ray longer =
        to_world({.origin = {1, 5, 10}, .direction = {0, 0, -3}}, pitched, {7, 8, 9});
    CHECK(gives("the same .origin for {1, 5, 10} and a longer direction", longer.origin,
                Vec3(8, 18, 14)));
}

TEST_CASE("the direction has the same length in the world (MRT §2)") {
    CHECK(for_all([](Random& random) {
        const Basis basis = random.basis();
        const Vec3 direction = random.power_of_two() * random.point(2);
        const Ray ray = to_world({.origin = Vec3(0), .direction = direction}, basis, Vec3(0));
        return gives("the length of to_world's direction", length(ray.direction),
                     length(direction));
    }));
}

TEST_CASE("the view matrix maps the camera to 0, and the view direction to -z (M1)",
          "[part view_matrix]") {
    const Vec3 position(7, 8, 9);
    const Basis basis{
        .x = {1, 0, 0}, .y = {0, Real(0.8), Real(-0.6)}, .z = {0, Real(0.6), Real(0.8)}};
    const Mat4 view = view_matrix(basis, position);
    const auto seen = [&view](Vec3 point) { return Vec3(view * Vec4(point, 1)); };
    CHECK(gives("the camera's position", seen(position), Vec3(0)));
    CHECK(gives("five ahead", seen(position - Real(5) * basis.z), Vec3(0, 0, -5)));
    CHECK(gives("two to the right", seen(position + Real(2) * basis.x), Vec3(2, 0, 0)));
    CHECK(gives("three up", seen(position + Real(3) * basis.y), Vec3(0, 3, 0)));
    CHECK(gives("w", (view * Vec4(1, 2, 3, 1)).w, Real(1)));
    const Basis to_the_left{.x = {0, 0, -1}, .y = {0, 1, 0}, .z = {1, 0, 0}};
    const Mat4 other = view_matrix(to_the_left, position);
    CHECK(gives("five ahead, of another camera there", Vec3(other * Vec4(2, 8, 9, 1)),
                Vec3(0, 0, -5)));
}

TEST_CASE("the view matrix undoes what carries a ray into the world (M1, MRT §2)") {
    CHECK(for_all([](Random& random) {
        const Basis basis = random.basis();
        const Vec3 position = random.point(4);
        const Vec3 point = random.point(4);
        const Ray ray = to_world({.origin = point, .direction = {0, 0, -1}}, basis, position);
        const Mat4 view = view_matrix(basis, position);
        return gives("view_matrix(" + code(basis) + ", " + code(position) + ") of the point " +
                         code(ray.origin),
                     Vec3(view * Vec4(ray.origin, 1)), point);
    }));
}

TEST_CASE("MRT's ray and M1's, through the view matrix, are the same (MRT §1–2, M1)",
          "[part together]") {
    CHECK(for_all([](Random& random) {
        const Resolution size{.width = 1 + random.below(640), .height = 1 + random.below(480)};
        const Pixel pixel{.row = random.below(size.height), .column = random.below(size.width)};
        const Real fov = random.between(Real(0.5), 2);
        const Vec3 position = random.point(2);
        const Vec3 direction = random.direction();

        const glm::dmat4 view(view_matrix(camera_basis(direction), position));
        const double width = size.width;
        const double height = size.height;
        const glm::dmat4 image =
            glm::translate(glm::dmat4(1), glm::dvec3(width / 2, height / 2, 0)) *
            glm::scale(glm::dmat4(1), glm::dvec3(width / 2, -height / 2, 1)) *
            glm::perspective(double(fov), width / height, 1.0, 16.0) * view;
        const Ray m1 = unprojected_ray(pixel, Mat4(glm::inverse(view)), Mat4(glm::inverse(image)));
        const Ray mrt = to_world(camera_ray(pixel, size, fov), camera_basis(direction), position);
        if (const Verdict origin = gives("M1's origin", m1.origin, mrt.origin); !origin)
            return origin;
        return gives("M1's direction", unit(m1.direction), unit(mrt.direction));
    }));
}

TEST_CASE("the picture of the stage (MRT §2)") {
    CHECK(picture_matches("step02_camera_basis"));
}
