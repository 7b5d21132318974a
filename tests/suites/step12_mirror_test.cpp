// Stage 12 against CR §5.1.
#include "steps/step12_mirror/mirror.hpp"

#include "common/render/closest_hit.hpp"
#include "common/render/stage.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"

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

std::string question(const Ray& ray, const ShadingPoint& surface) {
    return "mirrored(" + code(ray) + ",\n           " + code(surface) + ")";
}

/// The reflected ray has this direction; `keeps_length` tests its length.
Verdict sends(const Ray& ray, const ShadingPoint& surface, Vec3 expected) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(close(unit(got), unit(expected)),
                   question(ray, surface) + ".direction\n  got:      " + text(got) +
                       "\n  expected: " + text(expected) + "\n  paste:    CHECK(sends(" +
                       code(ray) + ", " + code(surface) + ", " + code(expected) + "));");
}

Verdict keeps_length(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(as_long(got, ray.direction),
                   question(ray, surface) + ".direction\n  got:      " + text(got) +
                       ", of length " + text(length(got)) + "\n  expected: the length of d, " +
                       text(length(ray.direction)) + "\n  paste:    CHECK(keeps_length(" +
                       code(ray) + ", " + code(surface) + "));");
}

/// The ray sent on starts above the surface, by surface.error, and by not much more.
Verdict starts_off(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 away = mirrored(ray, surface).origin - surface.point;
    const Real rounding = 4 * epsilon * (length(surface.point) + surface.error);
    const bool above = dot(away, surface.geometric_normal) >= surface.error - rounding;
    const bool near = length(away) <= 4 * surface.error + rounding;
    return verdict(
        above && near,
        question(ray, surface) + ".origin\n  got:      " +
            text(dot(away, surface.geometric_normal)) + " above the face, " + text(length(away)) +
            " from surface.point\n  expected: above by surface.error = " + text(surface.error) +
            " or a little more" + "\n  paste:    CHECK(starts_off(" + code(ray) + ", " +
            code(surface) + "));");
}

/// The reflected ray leaves the face.
Verdict goes_away(const Ray& ray, const ShadingPoint& surface) {
    const Vec3 got = mirrored(ray, surface).direction;
    return verdict(
        dot(got, surface.geometric_normal) > 0,
        question(ray, surface) + ".direction\n  got:      " + text(got) + ", " +
            text(dot(got, surface.geometric_normal)) + " along surface.geometric_normal" +
            "\n  expected: away from the face: more than 0 along surface.geometric_normal" +
            "\n  paste:    CHECK(goes_away(" + code(ray) + ", " + code(surface) + "));");
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
    return verdict(dot(got, surface.geometric_normal) > 0,
                   question(ray, surface) + ".direction\n  got:      " + text(got) +
                       "\n  expected: away from the mirror");
}

/// With a normal that is interpolated: up to half a right angle or so from the face's own.
Seen draw_interpolated(Random& random) {
    Seen seen = draw_seen(random);
    seen.surface.normal =
        unit(seen.surface.geometric_normal + random.between(0, 1) * random.direction());
    return seen;
}

Verdict worth(int bounces, int depth, Real weight, bool expected) {
    const auto word = [](bool yes) { return yes ? "true" : "false"; };
    const std::string call = "worth_reflecting(" + std::to_string(bounces) + ", " +
                             std::to_string(depth) + ", " + code(weight) + ")";
    const bool got = worth_reflecting(bounces, depth, weight);
    return verdict(got == expected, call + "\n  got:      " + word(got) +
                                        "\n  expected: " + word(expected) + "\n  paste:    CHECK(" +
                                        (expected ? "" : "!") + call + ");");
}

/// The condition that ends the trace in a scene of perfect mirrors, tested before such a scene is
/// traced.
Verdict stops_at(int depth) {
    Verdict stops;
    for (int bounces = depth; stops && bounces < depth + 4; ++bounces)
        stops = worth(bounces, depth, 1, false);
    return stops;
}

Verdict mixes(Color own, Color reflection, Real mirror, Color expected) {
    return gives("mixed(" + code(own) + ", " + code(reflection) + ", " + code(mirror) + ")",
                 mixed(own, reflection, mirror), expected);
}

/// The color from `trace`, or a failure with the sentence `what`.
Verdict sees(const std::string& what, const Scene& scene, const Ray& ray, Color expected,
             int depth = 8) {
    if (const Verdict stops = stops_at(depth); !stops) return stops;
    Context context{.settings = {.depth = depth}};
    return gives("trace(" + what + ", " + code(ray) + ") with --depth " + std::to_string(depth),
                 trace(scene, ray, context), expected);
}

/// The number of reflections that `trace` computes in a scene without lights: every ray but the
/// first is one.
Verdict reflections(const std::string& what, const Scene& scene, const Ray& ray, int expected,
                    int depth = 8) {
    if (const Verdict stops = stops_at(depth); !stops) return stops;
    Context context{.settings = {.depth = depth}};
    static_cast<void>(trace(scene, ray, context));
    const auto got = context.rays - 1;
    return verdict(got == expected, "the reflections of trace(" + what + ", " + code(ray) +
                                        ") with --depth " + std::to_string(depth) +
                                        "\n  got:      " + std::to_string(got) +
                                        "\n  expected: " + std::to_string(expected));
}

const Color red{1, Real(0.25), 0};
const Color blue{0, Real(0.25), 1};
const Ambient everywhere{.ratio = 1};  // a lit surface shows its own color

/// Two facing walls, four apart, a red and a blue one. A ray that runs across is reflected to and
/// fro.
Scene facing_walls(Real mirror) {
    Scene scene;
    scene.ambient = everywhere;
    scene.planes.push_back({.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}},
                            .material = {.color = red, .mirror = mirror}});
    scene.planes.push_back({.shape = {.point = {-2, 0, 0}, .normal = {1, 0, 0}},
                            .material = {.color = blue, .mirror = mirror}});
    return scene;
}

const Ray across{.origin = {1, 0, 0}, .direction = {1, 0, 0}};
const Ray aslant{.origin = {1, 0, 0}, .direction = {1, Real(0.5), Real(0.25)}};

/// The geometric sum: each mirror's own share of the weight that the mirrors before it left.
Color facing_sum(Real mirror, int depth) {
    Color sum(0);
    Real weight = 1;
    for (int wall = 0; wall <= depth; ++wall, weight *= mirror)
        sum += weight * (1 - mirror) * (wall % 2 == 0 ? red : blue);
    return sum;
}

/// A mirror all around, of radius √2, in which a ray along a side of the inscribed square returns
/// after four reflections; and a red sphere on the first side, behind the ray's start.
Scene inside_of_mirror() {
    Scene scene;
    scene.ambient = everywhere;
    scene.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = std::sqrt(Real(2))},
                             .material = {.color = blue, .mirror = 1}});
    scene.spheres.push_back({.shape = {.center = {Real(-0.5), -1, 0}, .radius = Real(0.25)},
                             .material = {.color = red}});
    return scene;
}

const Ray round_the_square{.origin = {0, -1, 0}, .direction = {1, 0, 0}};

}  // namespace

TEST_CASE("the direction is d - 2 n times d.n (CR §5.1, equation 4)", "[3 points]") {
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

TEST_CASE("it starts off the surface, by its error or a little more (contract, erratum 31)") {
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

TEST_CASE("an interpolated normal never sends the ray below the flat face (CR §6)") {
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
}

namespace {

/// A shape of size 1 or so at the origin, one of each kind there is.
Scene draw_shape(Random& random) {
    const Basis basis = random.basis();
    const Real height = random.between(1, 3);
    Scene scene;
    switch (random.below(6)) {
        case 0:
            scene.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = 1}});
            break;
        case 1:
            scene.planes.push_back({.shape = {.point = {0, 0, 0}, .normal = basis.z}});
            break;
        case 2:
            scene.triangles.push_back({.shape = {basis.x, basis.y, -basis.x - basis.y}});
            break;
        case 3:
            scene.squares.push_back({.shape = {.center = {0, 0, 0}, .basis = basis, .side = 1}});
            break;
        case 4:
            scene.cylinders.push_back({.shape = {.axis = basis.z, .radius = 1, .height = height}});
            break;
        default:
            scene.cones.push_back({.shape = {.apex = -height / 2 * basis.z,
                                             .axis = basis.z,
                                             .radius = 1,
                                             .height = height}});
    }
    return scene;
}

template <class Shape>
PrimitiveList<Shape> moved_items(const PrimitiveList<Shape>& primitives,
                                 const Transform& transform) {
    PrimitiveList<Shape> result;
    for (const Primitive<Shape>& primitive : primitives)
        result.push_back({.shape = transformed(primitive.shape, transform)});
    return result;
}

Scene moved_scene(const Scene& scene, const Transform& transform) {
    Scene result;
    result.spheres = moved_items(scene.spheres, transform);
    result.planes = moved_items(scene.planes, transform);
    result.triangles = moved_items(scene.triangles, transform);
    result.squares = moved_items(scene.squares, transform);
    result.cylinders = moved_items(scene.cylinders, transform);
    result.cones = moved_items(scene.cones, transform);
    return result;
}

std::string code_of_shape(const Scene& scene) {
    if (!scene.spheres.empty()) return code(scene.spheres.front().shape);
    if (!scene.planes.empty()) return code(scene.planes.front().shape);
    if (!scene.triangles.empty()) return code(scene.triangles.front().shape);
    if (!scene.squares.empty()) return code(scene.squares.front().shape);
    if (!scene.cylinders.empty()) return code(scene.cylinders.front().shape);
    return code(scene.cones.front().shape);
}

std::optional<Hit> first_hit(const Scene& scene, const Ray& ray) {
    Context context;
    ClosestHit closest(ray, context);
    visit_shapes(closest, scene);
    return closest.hit();
}

/// The ray hits the shape; the reflected ray does not hit it again where it left, within a
/// hundredth of its size. (Seen from inside, it does hit it farther away.)
Verdict leaves(const Scene& scene, const Ray& ray, Real size) {
    const std::optional<Hit> hit = first_hit(scene, ray);
    if (!hit) return {};
    // Inside a cone's tip the other side is as near as one likes.
    if (!scene.cones.empty() && distance(hit->point, scene.cones.front().shape.apex) < size / 4)
        return {};
    const ShadingPoint surface = shading_point(*hit, ray);
    const Ray sent = mirrored(ray, surface);
    const std::optional<Hit> next = first_hit(scene, sent);
    const Real way = next ? next->t * length(sent.direction) : infinity;
    return verdict(way > size / 100 * std::abs(dot(unit(ray.direction), surface.geometric_normal)),
                   question(ray, surface) + ",\n           which it sends on from " +
                       code_of_shape(scene) + "\n  got:      " + code(sent) +
                       ", which meets it again after " + text(way) +
                       "\n  expected: it leaves the surface, and does not meet it there");
}

}  // namespace

TEST_CASE("it does not meet the surface that it leaves, however large or small (erratum 31)") {
    // Sizes from 1e-6 to 1e6. The sphere is seen from inside, where a constant offset is past the
    // other side of a small one and lost in the rounding of a large one.
    const auto other_side_is_met = [](Real size, Vec3 center, Vec3 direction) {
        const Sphere sphere{.center = size * center, .radius = size};
        const Ray ray{.origin = sphere.center, .direction = direction};
        Scene scene;
        scene.spheres.push_back({.shape = sphere});
        const ShadingPoint surface = shading_point(first_hit(scene, ray).value(), ray);
        const Ray sent = mirrored(ray, surface);
        const std::optional<Hit> other_side = first_hit(scene, sent);
        const Real way = other_side ? other_side->t * length(sent.direction) : infinity;
        return gives("the way, in radii, on which " + question(ray, surface) +
                         "\n  comes to the other side of " + code(sphere),
                     way / size, Real(2));
    };
    Verdict across_it;
    for (int exponent = -6; across_it && exponent <= 6; ++exponent)
        across_it = other_side_is_met(std::pow(Real(10), Real(exponent)), {3, 2, 0}, {3, 4, 0});
    CHECK(across_it);
    CHECK(for_all([other_side_is_met](Random& random) {
        const Real size = std::pow(Real(10), Real(random.below(13) - 6));
        const Vec3 center = random.point(3);
        return other_side_is_met(size, center, random.between(1, 5) * random.direction());
    }));
    CHECK(for_all(
        [](Random& random) {
            Transform transform;
            transform.scale = std::pow(Real(10), Real(random.below(13) - 6));
            transform.rotation = random.basis();
            transform.translation = transform.scale * random.point(8);
            const Vec3 eye = random.point(4);
            const Vec3 aim = random.point(1);
            // Any length relative to the scene: in float, the products stay far from underflow.
            const Ray ray{.origin = transformed(eye, transform),
                          .direction = random.power_of_two() * rotated(aim - eye, transform)};
            return leaves(moved_scene(draw_shape(random), transform), ray, transform.scale);
        },
        2000));
}

TEST_CASE("the surface's own part and the reflected part sum to one (contract)") {
    const Color own{1, Real(0.5), 0};
    const Color reflection{0, Real(0.25), Real(0.5)};
    CHECK(mixes(own, reflection, 0, own));
    CHECK(mixes(own, reflection, 1, reflection));
    CHECK(mixes(own, reflection, Real(0.5), {Real(0.5), Real(0.375), Real(0.25)}));
    CHECK(mixes(own, reflection, Real(0.75), {Real(0.25), Real(0.3125), Real(0.375)}));
}

TEST_CASE("a mirror in a room of its own color is not seen: the shares add up (contract)") {
    CHECK(mixes(Color(0), Color(4), Real(0.25), Color(1)));  // and has another one in the mirror
    CHECK(for_all([](Random& random) {
        const Color color = abs(random.point(1));
        return mixes(color, color, random.between(0, 1), color);
    }));
}

TEST_CASE("colors brighter than white are reflected unclamped (contract)") {
    CHECK(mixes(Color(0), Color(4), Real(0.25), Color(1)));
    CHECK(mixes(Color(8), Color(0), Real(0.75), Color(2)));
}

TEST_CASE("no more reflections than the depth: there is a bound (contract)") {
    for (const int depth : {0, 1, 2, 8, 1000}) CHECK(stops_at(depth));
}

TEST_CASE("one bounce is one reflection (erratum 30, CR §2.1)") {
    CHECK(worth(0, 1, 1, true));
    CHECK(worth(1, 1, 1, false));
    CHECK(worth(1, 2, 1, true));
    CHECK(worth(2, 2, 1, false));
    Verdict all;
    for (int depth = 1; all && depth <= 20; ++depth)
        for (int bounces = 0; all && bounces < depth; ++bounces)
            all = worth(bounces, depth, 1, true);
    CHECK(all);
}

TEST_CASE("a weight of less than 1/512 is not worth a ray (contract)") {
    CHECK(worth(0, 8, Real(1) / 256, true));
    CHECK(worth(7, 8, Real(1) / 512, true));
    CHECK(worth(0, 8, Real(1) / 513, false));
    CHECK(worth(0, 8, Real(1) / 1024, false));
    CHECK(worth(0, 8, 0, false));
    CHECK(worth(0, 1000, Real(0.001), false));
}

TEST_CASE("between two facing mirrors a ray is reflected --depth times (CR §5.1)") {
    Verdict perfect;
    Verdict dim;
    for (const int depth : {0, 1, 2, 3, 7, 8, 30}) {
        if (perfect) perfect = reflections("two mirrors", facing_walls(1), across, depth, depth);
        if (dim) dim = reflections("two mirrors", facing_walls(Real(0.875)), aslant, depth, depth);
    }
    CHECK(perfect);
    CHECK(dim);
}

TEST_CASE("two facing mirrors show the geometric sum of their shares (CR §5.1)") {
    Verdict sums;
    for (const int depth : {0, 1, 2, 3, 7, 8}) {
        for (const Real mirror : {Real(0.5), Real(0.75), Real(0.9), Real(1)}) {  // of 1: black
            const Scene walls = facing_walls(mirror);
            const Color sum = facing_sum(mirror, depth);
            if (sums) sums = sees("two mirrors", walls, across, sum, depth);
            if (sums) sums = sees("two mirrors", walls, aslant, sum, depth);
        }
    }
    CHECK(sums);
    // Written out: ½ red, ¼ blue and ⅛ red.
    CHECK(sees("two mirrors", facing_walls(Real(0.5)), across,
               {Real(0.625), Real(0.21875), Real(0.25)}, 2));
}

TEST_CASE("shares of 0.1 stop after two reflections: 0.001 would not show (contract)") {
    // A power of two equals the bound exactly: (1/8)³ is 1/512, and (1/2)⁹ too.
    CHECK(reflections("two mirrors", facing_walls(Real(0.1)), across, 2));
    CHECK(reflections("two mirrors", facing_walls(Real(0.1)), across, 2, 1000));
    CHECK(reflections("two mirrors", facing_walls(Real(0.125)), across, 3, 1000));
    CHECK(reflections("two mirrors", facing_walls(Real(0.5)), across, 9, 1000));
    CHECK(sees("two mirrors", facing_walls(Real(0.1)), across, facing_sum(Real(0.1), 2), 1000));
}

TEST_CASE("a surface without a mirror part reflects no ray (contract)") {
    CHECK(reflections("two walls", facing_walls(0), across, 0));
    CHECK(sees("two walls", facing_walls(0), across, red));
}

TEST_CASE("a perfect mirror has no share to light: it sends no shadow rays (contract)") {
    Scene scene = facing_walls(1);
    scene.lights.push_back({.position = {0, 0, 1}});
    CHECK(reflections("two mirrors and a light", scene, across, 3, 3));
}

TEST_CASE("a mirror that sees nothing shows its own share (CR §5.1)") {
    Scene scene;
    scene.ambient = everywhere;
    scene.planes.push_back({.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}},
                            .material = {.color = red, .mirror = Real(0.75)}});
    CHECK(reflections("one mirror", scene, aslant, 1));
    CHECK(sees("one mirror", scene, aslant, Real(0.25) * red));
}

TEST_CASE(
    "in a mirror all around, a ray goes round the square, and sees behind its start (CR §5.1)") {
    const Scene scene = inside_of_mirror();
    CHECK(sees("a mirror all around", scene, round_the_square, Color(0), 0));
    CHECK(sees("a mirror all around", scene, round_the_square, Color(0), 3));
    CHECK(reflections("a mirror all around", scene, round_the_square, 3, 3));
    CHECK(sees("a mirror all around", scene, round_the_square, red, 4));
    CHECK(sees("a mirror all around", scene, round_the_square, red, 8));
    CHECK(reflections("a mirror all around", scene, round_the_square, 4, 8));
}

TEST_CASE("a wall is lit, and lit it is seen in a mirror that is lit (CR §3.1, §5.1)") {
    // Down at 45° onto a floor that is half a mirror, and up to a wall. The light is above the
    // floor's point: its cosine there is 1, and at the wall, 2 down and 2 along, 1/√2.
    Scene scene;
    scene.lights.push_back({.position = {0, 4, 0}, .brightness = Real(0.5)});
    scene.planes.push_back(
        {.shape = {.point = {0, 0, 0}}, .material = {.color = red, .mirror = Real(0.5)}});
    scene.planes.push_back(
        {.shape = {.point = {2, 0, 0}, .normal = {-1, 0, 0}}, .material = {.color = blue}});
    const Ray down{.origin = {-1, 1, 0}, .direction = {1, -1, 0}};
    const Color floor = Real(0.5) * red;
    const Color wall = Real(0.5) / std::sqrt(Real(2)) * blue;
    CHECK(sees("a floor and a wall", scene, down, Real(0.5) * floor + Real(0.5) * wall));
    CHECK(sees("a floor and a wall", scene, down, Real(0.5) * floor, 0));
}

TEST_CASE("the picture of the stage (CR §5.1)") {
    REQUIRE(stops_at(8));
    CHECK(picture_matches("step12_mirror", {.every = 4}));
}
