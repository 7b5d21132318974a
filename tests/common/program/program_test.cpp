// Tests of common/: stages, requirements, the field of view, transforms, the closest hit.

#include "common/geometry/transform.hpp"
#include "common/program/requirements.hpp"
#include "common/program/turntable.hpp"
#include "common/render/closest_hit.hpp"
#include "common/render/queries.hpp"
#include "common/stages/stages.hpp"

#include "steps/step08_cone/all_shapes.hpp"

#include "tests/documents/page.hpp"
#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;

namespace rt {

namespace {

/// A shape with given answers that records its queries.
struct Probe {
    std::optional<Real> t;
    Vec3 normal_there{0, 0, 1};
    Interval* asked = nullptr;
};

std::optional<Real> intersect(const Ray& /*ray*/, const Probe& probe, Interval interval) {
    if (probe.asked != nullptr) *probe.asked = interval;
    return probe.t && interval.contains(*probe.t) ? probe.t : std::nullopt;
}

Vec3 normal(const Probe& probe, Vec3 /*point*/) {
    return probe.normal_there;
}

PointWithError snapped_to(const Probe& /*probe*/, Vec3 point) {
    return {.point = point, .error = 0};
}

std::string code(const Probe& probe) {
    return probe.t ? "Probe at " + text(*probe.t) : "Probe nowhere";
}

std::string explain(PixelLog& /*story*/, const Ray& /*ray*/, const Probe& probe) {
    return probe.t ? "" : "it is nowhere";
}

std::string seen_in(const Scene& scene) {
    std::string all;
    for (const Advice& row : advice(scene)) all += (all.empty() ? "" : ", ") + row.seen;
    return all;
}

const Ray along_x{.origin = {0, 0, 0}, .direction = {1, 0, 0}};

}  // namespace

}  // namespace rt

TEST_CASE("a stage is found by its number, its topic and its name") {
    for (const char* name : {"5", "05", "step5", "step05", "triangle", "step05_triangle"})
        CHECK(find_stage(name) == 5);
    for (int stage = 1; stage <= 13; ++stage) {
        CHECK(find_stage(stage_name(stage)) == stage);
        CHECK(find_stage(std::to_string(stage)) == stage);
    }
    for (const char* name : {"", "0", "14", "-5", "+5", "5 ", "5.0", "step", "stepstep5", "tri",
                             "Triangle", "step05_", "step06_triangle", "99999999999999999999"})
        CHECK(find_stage(name) == std::nullopt);
}

TEST_CASE("a scene's requirements are listed in the order of the stages") {
    Scene scene;
    scene.cameras.resize(2);
    scene.cones = {Primitive<Cone>()};
    scene.spheres = {Primitive<Sphere>(), Primitive<Sphere>()};
    scene.triangles = PrimitiveList<Triangle>(std::vector<Primitive<Triangle>>(11302));
    const std::vector<Requirement> needs = requirements(scene);
    REQUIRE(needs.size() == 3);
    CHECK((needs[0].what == "2 spheres" && needs[0].stage == 3));
    CHECK((needs[1].what == "11302 triangles" && needs[1].stage == 5));
    CHECK((needs[2].what == "1 cone" && needs[2].stage == 8));
    scene.planes = {Primitive<Plane>()};
    scene.squares = {Primitive<Square>()};
    scene.cylinders = {Primitive<Cylinder>()};
    scene.boxes = {Primitive<OrientedBox>()};
    scene.mesh_requests.resize(1);
    CHECK(requirements(scene).size() == 8);
    CHECK(requirements(scene).back().what == "1 mesh");
}

TEST_CASE("light is required from stage 9 on, which brings it, and a mirror always") {
    Scene scene;
    scene.ambient = Ambient{};
    scene.lights = {Light{}, Light{.radius = 1}, Light{}};
    scene.spheres = {{.shape = {}, .material = {.specular = Real(0.5), .mirror = Real(0.5)}}};
    const std::vector<Requirement> by_torch = requirements(scene, 8);
    REQUIRE(by_torch.size() == 2);
    CHECK((by_torch[0].what == "1 sphere" && by_torch[0].stage == 3));
    CHECK((by_torch[1].what == "1 mirror" && by_torch[1].stage == 12));
    const std::vector<Requirement> by_light = requirements(scene, 9);
    REQUIRE(by_light.size() == 6);
    CHECK((by_light[1].what == "1 ambient light" && by_light[1].stage == 9));
    CHECK((by_light[2].what == "3 lights" && by_light[2].stage == 9));
    CHECK((by_light[3].what == "1 shape with a highlight" && by_light[3].stage == 9));
    CHECK((by_light[4].what == "1 light with a size" && by_light[4].stage == 11));
    CHECK(by_light[5].what == "1 mirror");
}

TEST_CASE("a sky is required from stage 3 on, which shows it") {
    Scene scene;
    scene.sky = Sky{};
    for (const int stage : {1, 3, 13}) {
        const std::vector<Requirement> needs = requirements(scene, stage);
        REQUIRE(needs.size() == 1);
        CHECK((needs[0].what == "1 sky" && needs[0].stage == 3));
    }
}

TEST_CASE("advice: what a scene has decides the rows, which are those of the page") {
    const Camera camera{.position = {0, 0, 10}, .direction = {0, 0, -1}, .fov = 1};
    const auto balls = [](std::size_t count, double mirror) {
        return PrimitiveList<Sphere>(std::vector<Primitive<Sphere>>(
            count,
            {.shape = {.center = {0, 0, 0}, .radius = 1}, .material = {.mirror = Real(mirror)}}));
    };
    Scene scene;
    scene.cameras = {camera};
    scene.lights = {Light{}};
    scene.spheres = balls(1, 0.8);
    CHECK(seen_in(scene) == "edges");  // a ball does not see itself
    scene.planes = {
        {.shape = {.point = {0, -2, 0}, .normal = {0, 1, 0}}, .material = {.mirror = Real(0.5)}}};
    CHECK(seen_in(scene) == "edges, mirrors");
    CHECK(advice(scene).back().mends == "--depth 24");  // 255 * 0.8^25 < 1 < 255 * 0.8^24
    scene.spheres = balls(1, 0.5);
    CHECK(seen_in(scene) == "edges");  // 255 / 2^9 < 1
    scene.spheres = balls(1, 0.8);
    scene.lights.push_back(Light{.radius = 1});
    CHECK(seen_in(scene) == "edges, a lamp with a size, mirrors");
    scene.mesh_requests.resize(1);
    CHECK(seen_in(scene) == "edges, a lamp with a size, mirrors, a mesh");
    scene.spheres = balls(100, 0.8);
    CHECK(seen_in(scene) ==
          "edges, a lamp with a size, mirrors, surfaces in one place, many shapes, a mesh");
    scene.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = Real(1e-3)}, .material = {}});
    scene.cameras[0].position = {0, 0, Real(1e4)};
    scene.resolution = {.width = 16, .height = 12};  // of which one pixel in a thousand is narrow
    const std::vector<Advice> rows = advice(scene);
    CHECK(rows.size() == 8);

    std::string page;
    for (const PageLine& line : read_page(project_file("docs/reference/accuracy.md")))
        page += line.text + "\n";
    std::erase(page, '`');
    for (const auto& [seen, wrong, mends, costs] : rows) {
        const std::string row =
            "\n| " + seen + " | " + wrong + " | " + mends + " | " + costs + " |";
        CAPTURE(row);
        CHECK(page.find(row) != std::string::npos);
    }
    std::istringstream lines(explanation(scene));
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 80);
}

TEST_CASE("a turning camera goes counterclockwise around the middle, and looks at the same place") {
    const Camera start{.position = {1, 1, 5}, .direction = {0, 0, -1}, .fov = 1};
    const Vec3 middle(1, 7, 0);
    const Camera quarter = turned(start, middle, Real(0.25));
    CHECK(close(quarter.position, Vec3(6, 1, 0)));
    CHECK(close(quarter.direction, Vec3(-1, 0, 0)));
    CHECK(quarter.fov == 1);
    CHECK(close(turned(start, middle, Real(0.5)).position, Vec3(1, 1, -5)));
    CHECK(turned(start, middle, 0).position == start.position);
}

TEST_CASE("a turning camera goes around the middle of all shapes but planes") {
    Scene scene;
    scene.planes = {Primitive<Plane>()};
    CHECK_FALSE(middle_of_shapes(scene));
    scene.spheres = {{.shape = {.center = {0, 0, 0}, .radius = 1}, .material = {}},
                     {.shape = {.center = {4, 0, 0}, .radius = 2}, .material = {}}};
    REQUIRE(middle_of_shapes(scene));
    CHECK(close(*middle_of_shapes(scene), Vec3(2.5, 0, 0)));
}

TEST_CASE("the vertical field of view is the one that is given, or follows from the horizontal") {
    const Camera vertical{.fov = 1};
    CHECK(vertical_fov(vertical, {.width = 640, .height = 480}) == 1);
    const Camera horizontal{.fov = pi / 2, .fov_axis = FovAxis::horizontal};
    CHECK(close(vertical_fov(horizontal, {.width = 100, .height = 100}), pi / 2));
    // tan 45° = 1 half the width away: half the height is 3/4, then 2.
    CHECK(
        close(vertical_fov(horizontal, {.width = 640, .height = 480}), 2 * std::atan(Real(0.75))));
    CHECK(close(vertical_fov(horizontal, {.width = 240, .height = 480}), 2 * std::atan(Real(2))));
    const Camera closed{.fov = 0, .fov_axis = FovAxis::horizontal};
    CHECK(vertical_fov(closed, {.width = 640, .height = 480}) == 0);
}

TEST_CASE("a motion turns, then scales, then moves, every part of every shape") {
    // A quarter turn about z: x becomes y, y becomes −x.
    const Transform transform{.rotation = {.x = {0, 1, 0}, .y = {-1, 0, 0}, .z = {0, 0, 1}},
                              .scale = 2,
                              .translation = {10, 20, 30}};
    const Vec3 p(1, 2, 3);
    const Vec3 there(6, 22, 36);
    const Vec3 up(0, 1, 0);
    const Vec3 left(-1, 0, 0);
    CHECK(rotated(p, transform) == Vec3(-2, 1, 3));
    CHECK(transformed(p, transform) == there);
    CHECK(transformed(p, Transform{}) == p);

    const Ray ray = transformed(Ray{.origin = p, .direction = {1, 0, 0}}, transform);
    CHECK((ray.origin == there && ray.direction == Vec3(0, 2, 0)));
    const Sphere sphere = transformed(Sphere{.center = p, .radius = 3}, transform);
    CHECK((sphere.center == there && sphere.radius == 6));
    const Plane plane = transformed(Plane{.point = p, .normal = up}, transform);
    CHECK((plane.point == there && plane.normal == left));
    const Triangle triangle =
        transformed(Triangle{.a = p, .b = {0, 0, 0}, .c = {1, 0, 0}}, transform);
    CHECK(
        (triangle.a == there && triangle.b == Vec3(10, 20, 30) && triangle.c == Vec3(10, 22, 30)));
    const Square square = transformed(Square{.center = p, .side = 4, .one_sided = true}, transform);
    CHECK((square.center == there && square.side == 8 && square.one_sided));
    CHECK((square.basis.x == up && square.basis.y == left && square.basis.z == Vec3(0, 0, 1)));
    const auto cylinder =
        transformed(Cylinder{.center = p, .axis = up, .radius = 3, .height = 5}, transform);
    CHECK((cylinder.center == there && cylinder.axis == left));
    CHECK((cylinder.radius == 6 && cylinder.height == 10));
    const Cone cone = transformed(Cone{.apex = p, .axis = up, .radius = 3, .height = 5}, transform);
    CHECK((cone.apex == there && cone.axis == left && cone.radius == 6 && cone.height == 10));
}

TEST_CASE("a moved ray's points keep their t (HAI)") {
    CHECK(for_all([](Random& random) {
        const Transform transform{.rotation = random.basis(),
                                  .scale = random.power_of_two(),
                                  .translation = random.point(4)};
        const Ray ray{.origin = random.point(4), .direction = random.direction()};
        const Real t = random.between(0, 4);
        const Vec3 got =
            (at(transformed(ray, transform), t) - transform.translation) / transform.scale;
        const Vec3 expected =
            (transformed(at(ray, t), transform) - transform.translation) / transform.scale;
        // Taking off the translation leaves its rounding, in units of the scale.
        const Real slack = tolerance * (8 + 4 / transform.scale);
        return verdict(length(got - expected) <= slack,
                       text(got) + " is not " + text(expected) + " for " + code(ray));
    }));
}

TEST_CASE("an open interval: neither its ends, nor infinity, nor NaN") {
    const Interval whole;
    CHECK(whole.contains(std::numeric_limits<Real>::denorm_min()));
    CHECK(whole.contains(std::numeric_limits<Real>::max()));
    for (const Real t : {Real(0), Real(-0.0), Real(-1), infinity, -infinity, Real(NAN)})
        CHECK_FALSE(whole.contains(t));
    const Interval part{.min = 1, .max = 2};
    CHECK(part.contains(Real(1.5)));
    CHECK_FALSE(part.contains(1));
    CHECK_FALSE(part.contains(2));
}

TEST_CASE("the closest of all kinds of shapes, with its own point, normal and material (M1)") {
    const PrimitiveList<Probe> first(
        {{.shape = {.t = Real(4)}}, {.shape = {.t = std::nullopt}}, {.shape = {.t = Real(3)}}});
    const PrimitiveList<Probe> second(
        {{.shape = {.t = Real(2), .normal_there = {0, 1, 0}}, .material = {Color(1, 0, 0)}},
         {.shape = {.t = Real(5)}}});
    for (const bool exchanged : {false, true}) {
        Context context;
        ClosestHit closest(along_x, context);
        CHECK_FALSE(closest.hit());
        closest.test(exchanged ? second : first);
        closest.test(PrimitiveList<Probe>());
        closest.test(exchanged ? first : second);
        const std::optional<Hit> hit = closest.hit();
        REQUIRE(hit);
        CHECK(hit->t == 2);
        CHECK(hit->point == Vec3(2, 0, 0));
        CHECK(hit->normal == Vec3(0, 1, 0));
        CHECK(hit->material == &second[0].material);
        CHECK(context.rays == 1);
    }
}

TEST_CASE("a hit shortens the interval of the shapes after it, and a tie stays with the first") {
    Interval asked;
    const PrimitiveList<Probe> shapes(
        {{.shape = {.t = Real(2)}}, {.shape = {.t = Real(2), .asked = &asked}}});
    Context context;
    ClosestHit closest(along_x, context);
    closest.test(shapes);
    CHECK(asked.min == 0);
    CHECK(asked.max == 2);
    CHECK(closest.hit()->material == &shapes[0].material);
}

TEST_CASE("a shape that is smaller than the error of its points faces the eye") {
    const Vec3 far(Real(1e6), Real(2e6), Real(-1e6));
    const auto normal_of = [far](const auto& shape, Vec3 direction) {
        Context context;
        const Ray ray{.origin = far, .direction = direction};
        ClosestHit closest(ray, context);
        const PrimitiveList<std::remove_cvref_t<decltype(shape)>> one({{.shape = shape}});
        closest.test(one);
        REQUIRE(closest.hit());
        return closest.hit()->normal;
    };
    constexpr auto tiny = Real(1e-12);
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, -2), Vec3(3, 0, 4)}) {
        CHECK(normal_of(Sphere{.center = far, .radius = tiny}, direction) == unit(-direction));
        CHECK(normal_of(Cylinder{.center = far, .radius = tiny}, direction) == unit(-direction));
    }
    CHECK(normal_of(Sphere{.center = far, .radius = 10}, {2, 0, 0}).x > Real(0.9));
}

TEST_CASE("the story contains each tested shape, and counts the misses that it leaves out") {
    std::ostringstream out;
    PixelLog log(out);
    const Watch watch{.log = &log};
    Context context{.log = &log, .watch = &watch};
    ClosestHit closest(along_x, context);
    closest.test(PrimitiveList<Probe>({{.shape = {.t = Real(2)}}, {.shape = {.t = Real(3)}}}));
    closest.test(
        PrimitiveList<Probe>(std::vector(100, Primitive<Probe>{.shape = {.t = std::nullopt}})));
    CHECK(out.str().starts_with(
        "Probe at 2\n    → hit at t = 2\n"
        "Probe at 3\n    interval = (0, 2)\n    → not nearer: a hit at t = 3, behind the "
        "end of the interval\n"
        "Probe nowhere\n    interval = (0, 2)\n    → missed: it is nowhere\n"));
    CHECK(log.misses_left_out() == 101 - 24);
}
