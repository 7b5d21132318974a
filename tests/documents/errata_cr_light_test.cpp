// Errata of CR about light (its §3, §5): see tests/documents/errata.hpp.
#include "tests/documents/errata.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;

namespace {

/// CR §3.1's terms for a light along `light`, a normal and an eye along `eye`, all unit vectors.
struct Phong {
    Real diffuse;
    Real specular;
};

Phong printed_phong(Vec3 light, Vec3 normal, Vec3 eye, int shininess) {
    const Vec3 reflected = 2 * dot(light, normal) * normal - light;
    return {std::max(dot(light, normal), Real(0)),
            std::pow(std::max(dot(reflected, eye), Real(0)), Real(shininess))};
}

}  // namespace

TEST_CASE("erratum 14: a highlight without light, and ambient light once per light (CR §3.1)") {
    // The light is behind the surface, the eye before it.
    const Vec3 normal(0, 0, 1);
    const Vec3 light(Real(0.8), 0, Real(-0.6));
    const Vec3 eye(Real(-0.8), 0, Real(0.6));
    const Phong printed_terms = printed_phong(light, normal, eye, 1);
    CHECK(printed_terms.diffuse == 0);
    CHECK(close(printed_terms.specular, Real(0.28)));  // a highlight without light
    // Ambient light is added once per light: two lights give twice the ambient light.
    const Real ambient = Real(0.25);
    Real printed = 0;
    for (int i = 0; i < 2; ++i) printed += ambient + printed_terms.diffuse;
    CHECK(printed == 2 * ambient);
}

TEST_CASE("erratum 15: a point in shadow is black (CR §3.2)") {
    const Real ambient = Real(0.25);
    const Real direct = Real(0.5);  // diffuse and specular
    const auto printed = [&](bool blocked) { return blocked ? 0 : ambient + direct; };
    const auto right = [&](bool blocked) { return ambient + (blocked ? 0 : direct); };
    CHECK(printed(false) == right(false));
    CHECK(printed(true) == 0);
    CHECK(right(true) == ambient);
}

TEST_CASE("erratum 16: samples beside the light, occluders to 0.9, the last light only (CR §3.3)") {
    // A light of radius 2, four above the ground, and half-way a strip |x| < 1, endless along z.
    // Under the middle of the strip the visible parts of the light are symmetric.
    const Real radius = 2;
    constexpr int samples = 16;
    const auto free_share = [&](Real x, Real from, Real to) {
        int free = 0;
        for (int i = 0; i < samples; ++i) {
            const Real light = from + (to - from) * (Real(i) + Real(0.5)) / samples;
            if (std::abs((x + light) / 2) >= 1) ++free;  // the ray's x at the strip's height
        }
        return Real(free) / samples;
    };
    CHECK(free_share(Real(1.5), 0, radius) == Real(0.75));  // printed: rand() from 0 to radius
    CHECK(free_share(Real(-1.5), 0, radius) == 0);
    CHECK(free_share(Real(1.5), -radius, radius) == Real(0.375));
    CHECK(free_share(Real(-1.5), -radius, radius) == Real(0.375));
    // An occluder three along a unit direction, a light at five: between them, and past 0.9.
    const Real occluder = 3;
    CHECK_FALSE(occluder < Real(0.9));
    CHECK(occluder < 5);
    // "color =" in the loop over two lights, of 0.5 and 0.25; and "color *= shadow" takes the
    // ambient light, 0.125, along.
    const Real ambient = Real(0.125);
    const Real blocked = 0;
    Real printed = 0;
    Real right = ambient;
    for (const Real light : {Real(0.5), Real(0.25)}) {
        printed = ambient + light;
        right += light;
    }
    CHECK(printed == Real(0.375));
    CHECK(right == Real(0.875));
    CHECK(printed * blocked == 0);  // black, where ambient light is left
}

TEST_CASE("erratum 29: n must have unit length (CR eq. 4)") {
    const Vec3 d(1, -1, 0);
    const Vec3 n(0, 2, 0);
    CHECK(gives("R as printed", d - 2 * dot(d, n) * n, Vec3(1, 7, 0)));
    CHECK(gives("R", d - 2 * dot(d, n) / dot(n, n) * n, Vec3(1, 1, 0)));
}

TEST_CASE("erratum 30: a limit of one bounce allows none (CR §2.1, §5.1)") {
    // A mirror before a wall of brightness 1: what the camera sees, if `bounces` are allowed.
    const auto wall_in_mirror = [](int bounces, bool counts_the_first_ray) {
        int rays = counts_the_first_ray ? bounces : bounces + 1;
        if (rays-- == 0) return 0;  // the ray that hits the mirror
        if (rays-- == 0) return 0;  // the one that it reflects
        return 1;
    };
    CHECK(wall_in_mirror(1, true) == 0);  // printed: rayTrace passes 1, and the mirror is black
    CHECK(wall_in_mirror(2, true) == 1);
    CHECK(wall_in_mirror(1, false) == 1);
}

TEST_CASE("erratum 31: a constant distance is too large for a small scene (CR §3.2, §4.2, §5.1)") {
    // The same scene, ten thousand times smaller: an occluder 3 away, a light 5 away.
    for (const Real scale : {Real(1), Real(0.0001)}) {
        const Real occluder = 3 * scale;
        const Real light = 5 * scale;
        CHECK((occluder > Real(0.001) && occluder < light) == (scale == 1));  // printed
        CHECK((occluder > 0 && occluder < light));
    }
}
