// Stage 9, the terms of one light, against CR §3.1 and M1's torch.
#include "steps/step09_phong/phong.hpp"

#include "tests/kit/light.hpp"

#include "common/math/vector.hpp"

#include <cmath>
#include <limits>

using namespace rt;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// The call, the answer, the expected answer, and a line to paste into a test.
Verdict answers(const std::string& function, const std::string& check, const std::string& asked,
                Vec3 got, Vec3 expected) {
    return verdict(close(got, expected), function + "(" + asked + ")\n  got:      " + text(got) +
                                             "\n  expected: " + text(expected) +
                                             "\n  paste:    CHECK(" + check + "(" + asked + ", " +
                                             code(expected) + "));");
}

Verdict reflects(Vec3 to_light, Vec3 normal, Vec3 expected) {
    return answers("reflected", "reflects", "Vec3" + code(to_light) + ", Vec3" + code(normal),
                   reflected(to_light, normal), expected);
}

Verdict ambient_is(const ShadingPoint& surface, const Ambient& ambient, Color expected) {
    const std::string light =
        "Ambient{.ratio = " + code(ambient.ratio) + ", .color = " + code(ambient.color) + "}";
    return answers("ambient_term", "ambient_is", code(surface) + ",\n          " + light,
                   ambient_term(surface, ambient), expected);
}

Verdict diffuse_is(const ShadingPoint& surface, const Light& light, Color expected) {
    return answers("diffuse_term", "diffuse_is", code(surface) + ",\n          " + code(light),
                   diffuse_term(surface, light), expected);
}

Verdict specular_is(const ShadingPoint& surface, const Light& light, Color expected) {
    return answers("specular_term", "specular_is", code(surface) + ",\n          " + code(light),
                   specular_term(surface, light), expected);
}

Verdict dark(const ShadingPoint& surface, const Light& light) {
    if (const Verdict none = diffuse_is(surface, light, Color(0)); !none) return none;
    return specular_is(surface, light, Color(0));
}

const Light white{.position = {0, 0, 5}};
const Vec3 slanting(Real(0.6), 0, Real(0.8));  // a direction by whole numbers: 3, 4, 5
const Vec3 mirrored(Real(-0.6), 0, Real(0.8));

/// White, at the origin, facing +z.
ShadingPoint facing_z(Vec3 to_eye, Real shininess = 32) {
    return {.point = {0, 0, 0},
            .normal = {0, 0, 1},
            .geometric_normal = {0, 0, 1},
            .to_eye = to_eye,
            .material = {.specular = 1, .shininess = shininess}};
}

Light light_at(Vec3 position) {
    return {.position = position};
}

/// Five from the origin.
Light light_along(Vec3 direction) {
    return {.position = Real(5) * direction};
}

/// A surface and a light with known angles (CR §3.1): θ between L and N, α between R and V.
struct Lit {
    ShadingPoint surface;
    Light light;
    Real theta;
    Real alpha;
};

/// N, L and R in a plane in any orientation, and V rotated around R; any brightness, any colors.
Lit make_lit(Random& random, Real theta, Real alpha, Real round) {
    const Basis basis = random.basis();
    const Vec3 l = std::sin(theta) * basis.x + std::cos(theta) * basis.z;
    const Vec3 r = std::cos(theta) * basis.z - std::sin(theta) * basis.x;
    Vec3 beside = std::cos(round) * cross(basis.y, r) + std::sin(round) * basis.y;
    if (dot(std::cos(alpha) * r + std::sin(alpha) * beside, basis.z) < 0) beside = -beside;

    Lit lit{.theta = theta, .alpha = alpha};
    lit.surface = draw_surface(random, random.point(3));
    lit.surface.normal = basis.z;
    lit.surface.geometric_normal =
        unit(basis.z + Real(0.4) * random.direction());  // as on a smooth mesh
    lit.surface.to_eye = std::cos(alpha) * r + std::sin(alpha) * beside;
    lit.surface.material.shininess = random.between(Real(0.5), 64);
    lit.surface.material.mirror = random.below(4) == 0 ? Real(1) : random.between(0, 1);
    lit.light = {.position = lit.surface.point + random.between(Real(0.5), 8) * l,
                 .brightness = random.between(Real(0.1), 1),
                 .color = abs(random.point(1))};
    return lit;
}

/// Lit, and seen inside or outside the highlight.
Lit draw(Random& random) {
    const Real theta = random.between(0, Real(1.5));
    const Real alpha = random.between(0, Real(1.4));
    return make_lit(random, theta, alpha, random.between(-pi, pi));
}

/// The same, nearer to the origin or farther by a power of two.
Lit draw_at_a_scale(Random& random) {
    Lit lit = draw(random);
    const int most = sizeof(Real) == sizeof(float) ? 40 : 100;
    const Real scale = std::ldexp(Real(1), random.below(2 * most + 1) - most);
    lit.surface.point *= scale;
    lit.light.position *= scale;
    return lit;
}

/// An angle a little less than 90°, whose cosine is far above rounding.
Real draw_grazing(Random& random) {
    return std::acos(std::ldexp(Real(1), -7 - random.below(4)));
}

Color expected_diffuse(const Lit& lit) {
    return std::cos(lit.theta) * lit.light.brightness * lit.light.color *
           lit.surface.material.color;
}

Color expected_specular(const Lit& lit) {
    const Material& material = lit.surface.material;
    return material.specular * std::pow(std::cos(lit.alpha), material.shininess) *
           lit.light.brightness * lit.light.color;
}

}  // namespace

TEST_CASE("light leaves on the other side of the normal, at the same angle (CR §3.1)",
          "[part reflected][3 points]") {
    CHECK(reflects(slanting, {0, 0, 1}, mirrored));
    CHECK(reflects({0, 0, 1}, {0, 0, 1}, {0, 0, 1}));
    CHECK(reflects({1, 0, 0}, {0, 0, 1}, {-1, 0, 0}));
    CHECK(reflects({0, 1, 0}, slanting, {0, -1, 0}));
    CHECK(reflects(mirrored, slanting, {Real(0.936), 0, Real(-0.352)}));
    CHECK(for_all([](Random& random) {
        const Basis basis = random.basis();
        const Real theta = random.between(0, pi);
        const Vec3 along = std::cos(theta) * basis.z;
        const Vec3 across = std::sin(theta) * basis.x;
        return reflects(along + across, basis.z, along - across);
    }));
}

TEST_CASE("ambient light is its ratio, its color and the surface's, multiplied (CR §3.1)",
          "[part ambient_term]") {
    ShadingPoint surface = facing_z({0, 0, 1});
    surface.material.color = {1, Real(0.5), 0};
    CHECK(ambient_is(surface, {.ratio = Real(0.5), .color = {Real(0.5), 1, 1}},
                     {Real(0.25), Real(0.25), 0}));
    CHECK(ambient_is(surface, {.ratio = 1, .color = {1, 1, 1}}, {1, Real(0.5), 0}));
    CHECK(ambient_is(surface, {.ratio = 0, .color = {1, 1, 1}}, {0, 0, 0}));
}

TEST_CASE("ambient light is the same wherever the surface is, faces, or is seen from (CR §3.1)") {
    CHECK(for_all([](Random& random) {
        ShadingPoint surface = draw_surface(random, random.point(10));
        surface.material.mirror = random.between(0, 1);
        const Ambient ambient{.ratio = random.between(0, 1), .color = abs(random.point(1))};
        return ambient_is(surface, ambient, ambient.ratio * ambient.color * surface.material.color);
    }));
}

TEST_CASE("a light straight above shows the full color (CR §3.1)", "[part diffuse_term]") {
    ShadingPoint surface = facing_z(slanting);
    surface.material.color = {1, Real(0.5), Real(0.25)};
    CHECK(diffuse_is(surface, white, {1, Real(0.5), Real(0.25)}));
    CHECK(for_all([](Random& random) {  // rounding may make the cosine more than 1
        const Lit above = make_lit(random, 0, random.between(0, 1), 0);
        return diffuse_is(above.surface, above.light, expected_diffuse(above));
    }));
}

TEST_CASE("diffuse light is by the cosine between L and N (CR §3.1, M1)") {
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_along(slanting), Color(Real(0.8))));
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({-4, 0, 3}), Color(Real(0.6))));
    const Real small = Real(0.0078125);
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({std::sqrt(1 - small * small), 0, small}),
                     Color(small)));
    Light sphere = light_along(slanting);
    sphere.radius = 1;
    ShadingPoint mirror = facing_z({0, 0, 1});
    mirror.material.mirror = Real(0.5);
    CHECK(diffuse_is(mirror, sphere, Color(Real(0.8))));
    CHECK(for_all([](Random& random) {
        const Lit lit = draw(random);
        return diffuse_is(lit.surface, lit.light, expected_diffuse(lit));
    }));
    CHECK(for_all([](Random& random) {
        Lit grazing = make_lit(random, draw_grazing(random), 0, 0);
        grazing.light.brightness = 1;
        grazing.light.color = Color(1);
        grazing.surface.material.color = Color(1);
        return diffuse_is(grazing.surface, grazing.light, expected_diffuse(grazing));
    }));
}

TEST_CASE("L leads from the point to the light, wherever both are (CR §3.1)") {
    ShadingPoint surface = facing_z({0, 0, 1});
    surface.point = {10, 0, 0};
    CHECK(diffuse_is(surface, light_at({13, 0, 4}), Color(Real(0.8))));
    CHECK(diffuse_is(surface, light_at({4, 0, 8}), Color(Real(0.8))));
}

TEST_CASE("diffuse light of lights near and far away (CR §3.1)") {
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({0, 0, Real(0.125)}), Color(1)));
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({0, 0, 512}), Color(1)));
    CHECK(for_all([](Random& random) {
        const Lit lit = draw_at_a_scale(random);
        return diffuse_is(lit.surface, lit.light, expected_diffuse(lit));
    }));
}

TEST_CASE("brightness and color of the light multiply what it shows (CR §3.1)") {
    const Light dim{.position = {0, 0, 5}, .brightness = Real(0.25), .color = {1, Real(0.5), 0}};
    CHECK(diffuse_is(facing_z({0, 0, 1}), dim, {Real(0.25), Real(0.125), 0}));
    const Light off{.position = {0, 0, 5}, .brightness = 0};
    CHECK(diffuse_is(facing_z({0, 0, 1}), off, Color(0)));
}

TEST_CASE("a light at the eye is the torch: cos θ between N and the way to the eye (M1)") {
    const ShadingPoint surface = facing_z(slanting);
    CHECK(diffuse_is(surface, light_along(surface.to_eye), Color(Real(0.8))));
}

TEST_CASE("diffuse light does not depend on the eye or on the highlight (CR §3.1)") {
    CHECK(diffuse_is(facing_z(mirrored), light_along(slanting), Color(Real(0.8))));
    CHECK(diffuse_is(facing_z({1, 0, 0}), light_along(slanting), Color(Real(0.8))));
    ShadingPoint matt = facing_z(mirrored);
    matt.material.specular = 0;
    CHECK(diffuse_is(matt, light_along(slanting), Color(Real(0.8))));
}

TEST_CASE("the diffuse term of a light behind the surface is black (erratum 27, M1)") {
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({0, 0, -5}), Color(0)));
    CHECK(diffuse_is(facing_z({0, 0, 1}), light_at({3, 0, -4}), Color(0)));
    CHECK(for_all([](Random& random) {
        Lit lit = draw(random);
        lit.light.position = Real(2) * lit.surface.point - lit.light.position;  // through the point
        return diffuse_is(lit.surface, lit.light, Color(0));
    }));
}

TEST_CASE("a light in the plane of the surface shows nothing: ⟨L, N⟩ = 0 (CR §3.1)", "[exact]") {
    CHECK(dark(facing_z({0, 0, 1}), light_at({5, 0, 0})));
    CHECK(dark(facing_z({-1, 0, 0}), light_at({5, 0, 0})));  // R points to the eye
}

TEST_CASE("where R points to the eye, the highlight is full (CR §3.1)", "[part specular_term]") {
    CHECK(specular_is(facing_z({0, 0, 1}), white, Color(1)));
    CHECK(specular_is(facing_z(mirrored), light_along(slanting), Color(1)));
    ShadingPoint half = facing_z(mirrored);
    half.material.specular = Real(0.5);
    CHECK(specular_is(half, light_along(slanting), Color(Real(0.5))));
    CHECK(for_all([](Random& random) {  // rounding may make the cosine more than 1
        const Lit full = make_lit(random, random.between(0, Real(1.5)), 0, 0);
        return specular_is(full.surface, full.light, expected_specular(full));
    }));
}

TEST_CASE("beside R the highlight is ⟨R, V⟩ to the power of the shininess (CR §3.1)") {
    CHECK(specular_is(facing_z(slanting, 2), white, Color(Real(0.64))));
    CHECK(specular_is(facing_z(slanting, 1), white, Color(Real(0.8))));
    CHECK(specular_is(facing_z(slanting, 3), white, Color(Real(0.512))));
    // Far beside R, and of light that grazes the surface.
    const Real small = Real(0.015625);
    const Real large = std::sqrt(1 - small * small);
    CHECK(specular_is(facing_z({large, 0, small}, 1), white, Color(small)));
    CHECK(specular_is(facing_z({-large, 0, small}), light_along({large, 0, small}), Color(1)));
    const Real tiny = std::ldexp(Real(1), -14);
    CHECK(specular_is(facing_z(unit(Vec3(-1, 0, tiny)), 1), light_at({4, 0, 4 * tiny}), Color(1)));
    CHECK(specular_is(facing_z(slanting, 3), light_along(slanting), Color(Real(0.021952))));
    CHECK(for_all([](Random& random) {
        Lit beside = make_lit(random, 0, draw_grazing(random), 0);
        beside.light.brightness = 1;
        beside.light.color = Color(1);
        beside.surface.material.specular = 1;
        beside.surface.material.shininess = Real(0.5);
        return specular_is(beside.surface, beside.light, expected_specular(beside));
    }));
    CHECK(for_all([](Random& random) {
        const Lit lit = draw(random);
        return specular_is(lit.surface, lit.light, expected_specular(lit));
    }));
}

TEST_CASE("the highlight of lights near and far away, at points other than the origin (CR §3.1)") {
    ShadingPoint surface = facing_z(mirrored);
    surface.point = {10, 0, 0};
    CHECK(specular_is(surface, light_at({13, 0, 4}), Color(1)));
    CHECK(for_all([](Random& random) {
        const Lit lit = draw_at_a_scale(random);
        return specular_is(lit.surface, lit.light, expected_specular(lit));
    }));
}

TEST_CASE("highlights of fractional and of large shininess (CR §3.1)", "[exact]") {
    const Vec3 at_30_degrees(Real(0.5), 0, std::sqrt(Real(0.75)));
    CHECK(specular_is(facing_z(at_30_degrees, 4), white, Color(Real(0.5625))));
    CHECK(specular_is(facing_z(at_30_degrees, Real(0.5)), white,
                      Color(std::pow(Real(0.75), Real(0.25)))));
    CHECK(specular_is(facing_z(at_30_degrees, Real(2.5)), white,
                      Color(std::pow(Real(0.75), Real(1.25)))));
    const Vec3 at_2_degrees(Real(0.03125), 0, std::sqrt(Real(0.9990234375)));
    CHECK(specular_is(facing_z(at_2_degrees, 1024), light_at({0, 0, 4}),
                      Color(std::pow(Real(0.9990234375), Real(512)))));
    CHECK(specular_is(facing_z(at_2_degrees, 10240), light_at({0, 0, 4}),
                      Color(std::pow(Real(0.9990234375), Real(5120)))));
    CHECK(specular_is(facing_z({0, 0, 1}, 100000), light_at({0, 0, 4}), Color(1)));
    CHECK(specular_is(facing_z(at_30_degrees, 100000), white, Color(0)));
    CHECK(for_all([](Random& random) {
        Lit lit = draw(random);
        lit.surface.material.shininess = random.between(Real(0.5), 256);
        return specular_is(lit.surface, lit.light, expected_specular(lit));
    }));
}

TEST_CASE("the highlight moves with the eye (CR §3.1)") {
    const Light light = light_along(slanting);
    CHECK(specular_is(facing_z(mirrored, 2), light, Color(1)));
    CHECK(specular_is(facing_z({0, 0, 1}, 2), light, Color(Real(0.64))));
    CHECK(specular_is(facing_z({-1, 0, 0}, 2), light, Color(Real(0.36))));
    CHECK(specular_is(facing_z({0, 1, 0}, 2), light, Color(0)));
}

TEST_CASE("the highlight of a colored light on a blue surface has the light's color (CR §3.1)") {
    ShadingPoint blue = facing_z({0, 0, 1});
    blue.material.color = {0, 0, 1};
    const Light warm{.position = {0, 0, 5}, .color = {1, Real(0.5), 0}};
    CHECK(specular_is(blue, warm, {1, Real(0.5), 0}));
    const Light dim{.position = {0, 0, 5}, .brightness = Real(0.25), .color = {1, Real(0.5), 0}};
    CHECK(specular_is(facing_z({0, 0, 1}), dim, {Real(0.25), Real(0.125), 0}));
    const Light off{.position = {0, 0, 5}, .brightness = 0};
    CHECK(specular_is(facing_z({0, 0, 1}), off, Color(0)));
}

TEST_CASE("the highlight is black where R points away from the eye (CR §3.1)") {
    // ⟨R, V⟩ = -0.352, whose square is positive, its cube negative, and its root not a number.
    const Vec3 low(Real(0.96), 0, Real(0.28));
    for (const Real shininess : {Real(2), Real(3), Real(2.5)})
        CHECK(specular_is(facing_z(low, shininess), light_along(slanting), Color(0)));
    CHECK(for_all([](Random& random) {
        const Real theta = random.between(Real(0.2), Real(1.5));
        const Real alpha = random.between(pi / 2 + Real(0.05), pi / 2 + theta - Real(0.05));
        Lit away = make_lit(random, theta, alpha, 0);
        if (random.coin()) away.surface.material.shininess = Real(1 + random.below(4));
        return specular_is(away.surface, away.light, Color(0));
    }));
}

TEST_CASE(
    "the highlight of a light behind the surface is black, with ⟨R, V⟩ > 0 (erratum 14, CR §3.1)") {
    // The numbers of docs/errata.md: printed, the highlight is 0.28.
    const Vec3 behind(Real(0.8), 0, Real(-0.6));
    CHECK(dark(facing_z({Real(-0.8), 0, Real(0.6)}, 1), light_along(behind)));
    CHECK(for_all([](Random& random) {
        const Real theta = random.between(pi / 2 + Real(0.02), Real(2.2));
        // R is below the surface: V must be above it, and at most 90° from R.
        const Real alpha = random.between(theta - pi / 2 + Real(0.1), pi / 2 - Real(0.1));
        const Lit hidden = make_lit(random, theta, alpha, 0);
        return dark(hidden.surface, hidden.light);
    }));
}

TEST_CASE("a surface without a specular part has no highlight (CR §3.1)") {
    ShadingPoint matt = facing_z({0, 0, 1});
    matt.material.specular = 0;
    CHECK(specular_is(matt, white, Color(0)));
}

TEST_CASE("the terms of a light at the point itself are black (contract)", "[part together]") {
    CHECK(dark(facing_z({0, 0, 1}), light_at({0, 0, 0})));
    CHECK(for_all([](Random& random) {
        const ShadingPoint surface = draw_surface(random, random.point(3));
        return dark(surface, light_at(surface.point));
    }));
}

TEST_CASE("the terms of a light with NaN are black (contract)") {
    CHECK(for_all([](Random& random) {
        Lit lit = draw(random);
        Vec3* const parts[] = {&lit.surface.point, &lit.surface.normal, &lit.light.position,
                               &lit.surface.to_eye};
        Vec3& part = *parts[random.below(4)];
        part[random.below(3)] = not_a_number;
        if (&part == &lit.surface.to_eye)  // diffuse light does not depend on it
            return specular_is(lit.surface, lit.light, Color(0));
        return dark(lit.surface, lit.light);
    }));
}
