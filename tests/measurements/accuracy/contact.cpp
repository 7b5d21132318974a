// Methods of leaving a surface, for scenes of every size: how often a shadow ray hits the surface
// that it leaves, and how often it misses an object before it, 1e-5 to 1e-1 of the scene away.
// tests/common/render/contact_test.cpp requires 0 for the reference, with closer objects.
#include "tests/measurements/accuracy/forms.hpp"
#include "tests/stability/sweeps.hpp"

#include "common/geometry/projection.hpp"
#include "common/geometry/transform.hpp"
#include "common/math/vector.hpp"
#include "common/render/surface.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step10_shadows/shadows.hpp"

#include <array>
#include <cmath>
#include <cstdio>

using namespace rt;

namespace {

constexpr int rays = 30'000;  // per shape and size

/// A method of leaving a surface; `hit` is o + t d, before its projection to surface.point.
struct Policy {
    const char* name;
    ShadowRay (*way)(const ShadingPoint& surface, Vec3 hit, Vec3 light);
};

ShadowRay off_by(Real distance, const ShadingPoint& surface, Vec3 hit, Vec3 light) {
    const Vec3 origin = hit + distance * surface.geometric_normal;
    return {.ray = {.origin = origin, .direction = light - origin},
            .interval = {.min = 0, .max = Real(0.999)}};
}

constexpr std::array policies = {
    Policy{"reference", [](const ShadingPoint& surface, Vec3 /*hit*/,
                           Vec3 light) { return shadow_ray(surface, light); }},
    Policy{"no epsilon", [](const ShadingPoint& surface, Vec3 hit,
                            Vec3 light) { return off_by(0, surface, hit, light); }},
    Policy{"1e-6 along the normal",
           [](const ShadingPoint& surface, Vec3 hit, Vec3 light) {
               return off_by(Real(1e-6), surface, hit, light);
           }},
    Policy{"1e-3 along the normal",
           [](const ShadingPoint& surface, Vec3 hit, Vec3 light) {
               return off_by(Real(1e-3), surface, hit, light);
           }},
    Policy{"CR §3.2: t > 0.001",
           [](const ShadingPoint& /*surface*/, Vec3 hit, Vec3 light) -> ShadowRay {
               return {.ray = {.origin = hit, .direction = unit(light - hit)},
                       .interval = {.min = Real(0.001), .max = distance(light, hit)}};
           }},
    Policy{"1e-4 of the coordinates",
           [](const ShadingPoint& surface, Vec3 hit, Vec3 light) {
               return off_by(Real(1e-4) * largest_component(hit), surface, hit, light);
           }},
};

/// The result of one method.
struct Tally {
    int asked = 0;
    int self_hits = 0;
    int missed = 0;
};

/// A direction away from the surface, at 6° or more.
Vec3 leaving(Random& random, Vec3 normal) {
    const Vec3 aside = unit(cross(normal, random.direction()));
    return unit(aside + random.between(Real(0.1), 2) * normal);
}

/// An ordinary ray at an ordinary shape, all of that size.
template <class Shape>
Case<Shape> of_size(Random& random, Real size) {
    Case<Shape> random_case;
    draw(random, Sweep::moderate, random_case);
    const Transform transform{.scale = size};
    return {.ray = {.origin = transformed(random_case.ray.origin, transform),
                    .direction = size * random_case.ray.direction},
            .shape = transformed(random_case.shape, transform)};
}

template <class Shape>
void ask(Random& random, Real size, std::array<Tally, policies.size()>& tallies) {
    const Case<Shape> seen = of_size<Shape>(random, size);
    const auto t = intersect(seen.ray, seen.shape, {});
    if (!t) return;
    const Vec3 hit = at(seen.ray, *t);
    if (largest_component(hit) > 10 * size) return;  // a plane's, no longer of the scene
    const auto [point, error] = snapped_to(seen.shape, hit);
    Vec3 side = normal(seen.shape, point);
    // From inside, the shape itself may block the light.
    if (dot(side, seen.ray.direction) > 0) return;
    const Vec3 way = leaving(random, side);
    const Vec3 light = point + 5 * size * way;
    const Real gap = size * std::pow(Real(10), random.between(-5, -1));
    const Sphere occluder{.center = point + 2 * gap * way, .radius = gap};
    const ShadingPoint surface{
        .point = point, .normal = side, .geometric_normal = side, .error = error};
    for (std::size_t i = 0; i < policies.size(); ++i) {
        const ShadowRay shadow = policies[i].way(surface, hit, light);
        ++tallies[i].asked;
        tallies[i].self_hits += intersect(shadow.ray, seen.shape, shadow.interval).has_value();
        tallies[i].missed += !intersect(shadow.ray, occluder, shadow.interval).has_value();
    }
}

template <class Shape>
void measure(const char* name) {
    for (int power = -6; power <= 6; ++power) {
        const Real size = std::pow(Real(10), Real(power));
        std::array<Tally, policies.size()> tallies;
        Random random(4);
        for (int i = 0; i < rays; ++i) ask<Shape>(random, size, tallies);
        for (std::size_t i = 0; i < policies.size(); ++i)
            std::printf("%s,%s,%s,%g,%d,%d,%d\n", name, policies[i].name, precision_word,
                        double(size), tallies[i].asked, tallies[i].self_hits, tallies[i].missed);
    }
}

}  // namespace

int main() {
    std::puts("shape,policy,precision,size,rays,self hits,missed");
    for_every_shape(
        []<class Shape>(const char* name, const Shape& /*shape*/) { measure<Shape>(name); });
}
