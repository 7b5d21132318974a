// The reflected ray of a surface against CR §5.1 and §6.
#include "steps/step12_mirror/mirror.hpp"

#include "tests/suites/step12_mirror/question.hpp"

#include <cmath>

using namespace rt;

namespace {

/// The length as it is, or nothing to be compared with where it is NaN.
bool as_long(Vec3 a, Vec3 b) {
    return std::abs(length(a) / length(b) - 1) <= tolerance;
}

/// A flat surface seen along the ray, with its point one direction length from the ray's origin.
ShadingPoint flat(const Ray& ray, Vec3 normal, Real error = 64 * unit_roundoff) {
    return {.point = at(ray, 1),
            .normal = normal,
            .geometric_normal = normal,
            .to_eye = unit(-ray.direction),
            .error = error};
}

/// The reflected ray has this direction; `keeps_length` tests its length.
Verdict sends(const Ray& ray, const ShadingPoint& surface, Vec3 expected) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(close(unit(got), unit(expected)), [&] {
        return question(ray, surface) + ".direction\n  got:      " + text(got) +
               "\n  expected: " + text(expected) + "\n  paste:    CHECK(sends(" + code(ray) + ", " +
               code(surface) + ", " + code(expected) + "));";
    });
}

Verdict keeps_length(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(as_long(got, ray.direction), [&] {
        return question(ray, surface) + ".direction\n  got:      " + text(got) + ", of length " +
               text(length(got)) + "\n  expected: the length of d, " + text(length(ray.direction)) +
               "\n  paste:    CHECK(keeps_length(" + code(ray) + ", " + code(surface) + "));";
    });
}

/// The ray sent on starts above the surface, by surface.error, and by not much more.
Verdict starts_off(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 away = mirrored(ray, surface).origin - surface.point;
    const Real rounding = 4 * epsilon * (length(surface.point) + surface.error);
    const bool above = dot(away, surface.geometric_normal) >= surface.error - rounding;
    const bool near = length(away) <= 4 * surface.error + rounding;
    return verdict(above && near, [&] {
        return question(ray, surface) +
               ".origin\n  got:      " + text(dot(away, surface.geometric_normal)) +
               " above the face, " + text(length(away)) +
               " from surface.point\n  expected: above by surface.error = " + text(surface.error) +
               " or a little more" + "\n  paste:    CHECK(starts_off(" + code(ray) + ", " +
               code(surface) + "));";
    });
}

/// The reflected ray leaves the face.
Verdict goes_away(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(dot(got, surface.geometric_normal) > 0, [&] {
        return question(ray, surface) + ".direction\n  got:      " + text(got) + ", " +
               text(dot(got, surface.geometric_normal)) + " along surface.geometric_normal" +
               "\n  expected: away from the face: more than 0 along surface.geometric_normal" +
               "\n  paste:    CHECK(goes_away(" + code(ray) + ", " + code(surface) + "));";
    });
}

/// A ray, and a flat surface that it hits from the side of the normal.
struct Seen {
    Ray ray;
    ShadingPoint surface;
};

/// No flatter than one in twenty.
Seen draw_seen(Random& random) {
    const Vec3 normal = random.direction();
    Vec3 direction = random.direction();
    if (dot(direction, normal) > 0) direction = -direction;
    if (dot(direction, normal) > Real(-0.05)) direction -= Real(0.1) * normal;
    const Ray ray{.origin = random.point(4), .direction = direction};
    return {.ray = ray,
            .surface = flat(ray, normal, 64 * unit_roundoff * (1 + length(at(ray, 1))))};
}

/// A ray from before the mirror is reflected to the same side.
Verdict comes_back(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(dot(got, surface.geometric_normal) > 0, [&] {
        return question(ray, surface) + ".direction\n  got:      " + text(got) +
               "\n  expected: away from the mirror";
    });
}

/// An interpolated normal sends the ray away just above the face, or would send it just below.
Verdict grazes_the_face(Random& random) {
    const auto [x, y, side] = random.basis();
    const Real rise = std::ldexp(Real(1), -3 - random.below(10));
    const bool above = random.coin();
    const Vec3 reflected = std::sqrt(1 - rise * rise) * x + (above ? rise : -rise) * side;
    const Vec3 arriving = unit(random.between(-1, 1) * x + random.between(-1, 1) * y - side);
    const Ray ray{.origin = random.point(4), .direction = random.power_of_two() * arriving};
    ShadingPoint surface = flat(ray, side);
    surface.normal = unit(reflected - arriving);
    if (above) return sends(ray, surface, reflected);
    if (const Verdict away = goes_away(ray, surface); !away) return away;
    return keeps_length(ray, surface);
}

/// With a normal that is interpolated: up to half a right angle or so from the face's own.
Seen draw_interpolated(Random& random) {
    Seen seen = draw_seen(random);
    seen.surface.normal =
        unit(seen.surface.geometric_normal + random.between(0, 1) * random.direction());
    return seen;
}

}  // namespace

TEST_CASE("the direction is d - 2 n times d.n (CR §5.1, equation 4)", "[part mirrored][3 points]") {
    const Real s = Real(0.6);
    const Real c = Real(0.8);
    const Ray down{.origin = {1, 2, 3}, .direction = {s, -c, 0}};
    CHECK(sends(down, flat(down, {0, 1, 0}), {s, c, 0}));
    const Ray left{.origin = {1, 2, 3}, .direction = {-c, 0, s}};
    CHECK(sends(left, flat(left, {1, 0, 0}), {c, 0, s}));
    // A mirror at 45° sends the ray round the corner.
    const Ray on{.origin = {0, 0, 0}, .direction = {0, 0, -1}};
    CHECK(sends(on, flat(on, unit(Vec3(1, 0, 1))), {1, 0, 0}));
    // Thirds: n = (2, 1, 2) / 3, and d = -x leaves (-1, 0, 0) + 2 (2/3) (2, 1, 2) / 3.
    const Ray thirds{.origin = {5, 0, 0}, .direction = {-1, 0, 0}};
    CHECK(sends(thirds, flat(thirds, Vec3(2, 1, 2) / Real(3)), Vec3(-1, 4, 8) / Real(9)));
    CHECK(for_all([](Random& random) {
        const auto [x, y, normal] = random.basis();
        const Vec3 along = random.between(-2, 2) * x;
        const Vec3 across = random.between(Real(0.1), 2) * normal;
        const Ray ray{.origin = random.point(4), .direction = along - across};
        return sends(ray, flat(ray, normal), along + across);
    }));
}

TEST_CASE("a ray straight at the mirror is reflected straight back (CR §5.1)") {
    const Ray straight{.origin = {0, 0, 5}, .direction = {0, 0, -1}};
    CHECK(sends(straight, flat(straight, {0, 0, 1}), {0, 0, 1}));
    CHECK(for_all([](Random& random) {
        const Vec3 normal = random.direction();
        const Ray ray{.origin = random.point(4), .direction = -normal};
        return sends(ray, flat(ray, normal), normal);
    }));
}

TEST_CASE("the angle of incidence is the angle of reflection (CR §5.1)") {
    CHECK(for_all([](Random& random) {
        const auto [ray, surface] = draw_seen(random);
        const Vec3 d = unit(ray.direction);
        const Vec3 r = unit(mirrored(ray, surface).direction);
        const Real in = dot(-d, surface.normal);
        const Real out = dot(r, surface.normal);
        return verdict(close(out, in),
                       question(ray, surface) + ".direction\n  got:      " + text(r) +
                           ", cosine to the normal " + text(out) +
                           "\n  expected: the same cosine as to the eye, " + text(in));
    }));
}

TEST_CASE("the reflected ray stays in the plane of the ray and the normal (CR §5.1)") {
    CHECK(for_all([](Random& random) {
        const auto [ray, surface] = draw_seen(random);
        if (!comes_back(ray, surface)) return comes_back(ray, surface);
        // The component along the mirror is unchanged.
        const auto along = [n = surface.normal](Vec3 v) { return v - dot(v, n) * n; };
        const Vec3 d = unit(ray.direction);
        const Vec3 r = unit(mirrored(ray, surface).direction);
        return gives("the part along the mirror of\n  " + question(ray, surface) + ".direction",
                     along(r), along(d));
    }));
}

TEST_CASE("a flat mirror shows a thing where its image is, as far behind (CR §5.1)") {
    CHECK(for_all([](Random& random) {
        // Eye and object at their heights above feet on the mirror. By similar triangles the eye
        // sees the object at the point that divides the line between the feet in the ratio of the
        // heights.
        const Basis basis = random.basis();
        const Vec3 foot = random.point(2);
        const Real eye_height = random.between(Real(0.5), 4);
        const Real thing_height = random.between(Real(0.5), 4);
        const Vec3 between_feet = random.between(-4, 4) * basis.x + random.between(-4, 4) * basis.y;
        const Vec3 eye = foot + eye_height * basis.z;
        const Vec3 thing = foot + between_feet + thing_height * basis.z;
        const Vec3 point = foot + eye_height / (eye_height + thing_height) * between_feet;
        const Ray ray{.origin = eye, .direction = point - eye};
        return sends(ray, flat(ray, basis.z), thing - point);
    }));
}

TEST_CASE("the direction is as long as d, whatever its length (contract, erratum 19)") {
    const Ray five_long{.origin = {0, 3, 0}, .direction = {4, -3, 0}};
    CHECK(keeps_length(five_long, flat(five_long, {0, 1, 0})));
    CHECK(for_all([](Random& random) {
        auto [ray, surface] = draw_seen(random);
        ray.direction *= random.power_of_two();
        if (const Verdict kept = keeps_length(ray, surface); !kept) return kept;
        return goes_away(ray, surface);
    }));
}

TEST_CASE("the reflected ray, sent back, is reflected along the first one (CR §5.1)") {
    CHECK(for_all([](Random& random) {
        auto [ray, surface] = draw_seen(random);
        if (!comes_back(ray, surface)) return comes_back(ray, surface);
        const Ray back{.origin = ray.origin, .direction = -mirrored(ray, surface).direction};
        surface.to_eye = unit(-back.direction);
        return sends(back, surface, -ray.direction);
    }));
    // The same surface from its other side: reflected twice, d is d again.
    CHECK(for_all([](Random& random) {
        const auto [ray, surface] = draw_seen(random);
        ShadingPoint rotated = surface;
        rotated.normal = -surface.normal;
        rotated.geometric_normal = -surface.geometric_normal;
        const Ray once{.origin = ray.origin, .direction = mirrored(ray, surface).direction};
        rotated.to_eye = unit(-once.direction);
        return sends(once, rotated, ray.direction);
    }));
}

TEST_CASE(
    "the reflected ray starts above the surface by its error or a little more (contract, erratum "
    "31)") {
    const Ray down{.origin = {1, 5, 0}, .direction = {3, -4, 0}};
    CHECK(starts_off(down, flat(down, {0, 1, 0}, Real(0.125))));
    CHECK(starts_off(down, flat(down, unit(Vec3(-1, 1, 1)), Real(0.125))));
    CHECK(for_all([](Random& random) {
        const auto [ray, surface] = draw_seen(random);
        return starts_off(ray, surface);
    }));
}

TEST_CASE("an interpolated normal is the one that reflects (CR §6)") {
    // The eye leans 15° to one side of the face's normal, the interpolated one 15° to the other:
    // 30° in, 30° out, which is 45° from the face's normal, and well above the face.
    const auto towards = [](Real degrees) {
        const Real angle = degrees * pi / 180;
        return Vec3(std::sin(angle), std::cos(angle), 0);
    };
    const Ray ray{.origin = {0, 4, 0}, .direction = -towards(-15)};
    ShadingPoint surface = flat(ray, {0, 1, 0});
    surface.normal = towards(15);
    CHECK(sends(ray, surface, towards(45)));
    CHECK(for_all([](Random& random) {
        // The eye's direction turned about the normal by half a turn, and it stays above the face.
        const Basis basis = random.basis();
        const Real lean = random.between(0, Real(0.35));
        const Real up = std::sqrt(1 - lean * lean);
        const Real turn = random.between(-pi, pi);
        const Real slant = random.between(0, Real(0.5));
        const Vec3 aside = std::cos(turn) * basis.x + std::sin(turn) * basis.y;
        const Ray seen{.origin = random.point(4), .direction = -unit(slant * aside + basis.z)};
        ShadingPoint smooth = flat(seen, basis.z);
        smooth.geometric_normal =
            unit(lean * basis.x + up * basis.z);  // at most 27° + 21° from either
        return sends(seen, smooth, unit(basis.z - slant * aside));
    }));
}

TEST_CASE("rays reflected by an interpolated normal leave above the flat face (CR §6)") {
    // The eye is 80° from the face's normal. The interpolated one leans away from it, by 8° or 30°:
    // with the first the ray would go 6° into the face, and the second faces away from the eye.
    const auto towards = [](Real degrees) {
        const Real angle = degrees * pi / 180;
        return Vec3(std::sin(angle), std::cos(angle), 0);
    };
    const Ray ray{.origin = {0, 1, 0}, .direction = Real(-2) * towards(-80)};
    for (const Real lean : {Real(8), Real(30)}) {
        ShadingPoint surface = flat(ray, {0, 1, 0}, Real(0.125));
        surface.normal = towards(lean);
        CHECK(goes_away(ray, surface));
        CHECK(keeps_length(ray, surface));
        CHECK(starts_off(ray, surface));
    }
    CHECK(for_all([](Random& random) {
        const auto [smooth_ray, smooth] = draw_interpolated(random);
        if (const Verdict away = goes_away(smooth_ray, smooth); !away) return away;
        return starts_off(smooth_ray, smooth);
    }));
    CHECK(for_all(grazes_the_face));
}
