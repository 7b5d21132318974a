// The meaning of a scene, as defined by docs/scenes.md, the source of the expected values.

#include "tests/common/scene_file/reading.hpp"

#include "common/math/vector.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/verdict.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

using namespace rt;

namespace {

bool nearly(Real value, Real expected) {
    return std::abs(value - expected) <= 4 * epsilon * std::max(std::abs(expected), Real(1));
}

bool nearly(Vec3 value, Vec3 expected) {
    return nearly(value.x, expected.x) && nearly(value.y, expected.y) &&
           nearly(value.z, expected.z);
}

}  // namespace

TEST_CASE("the new dialect: A C L sp pl cy") {
    const Scene scene = strict(
        "A 0.2 255,255,255\n"
        "C -50,0,20 0,0,1 90\n"
        "L -40,0,30 0.7 255,51,0\n"
        "sp 0,0,20 20 255,0,0\n"
        "pl 0,0,-10 0,1,0 0,0,225\n"
        "cy 50.0,0.0,20.6 0,0,1.0 14.2 21.42 10,0,255\n");
    REQUIRE(scene.ambient);
    CHECK(scene.ambient->ratio == Real(0.2));
    CHECK(scene.ambient->color == Color(1));
    REQUIRE(scene.cameras.size() == 1);
    CHECK(scene.cameras[0].position == Vec3(-50, 0, 20));
    CHECK(scene.cameras[0].direction == Vec3(0, 0, 1));
    CHECK(nearly(scene.cameras[0].fov, pi / 2));
    REQUIRE(scene.lights.size() == 1);
    CHECK(scene.lights[0].position == Vec3(-40, 0, 30));
    CHECK(scene.lights[0].brightness == Real(0.7));
    CHECK(scene.lights[0].color == Color(1, Real(0.2), 0));
    REQUIRE(scene.spheres.size() == 1);
    CHECK(scene.spheres[0].shape.center == Vec3(0, 0, 20));
    CHECK(scene.spheres[0].shape.radius == 10);
    CHECK(scene.spheres[0].material.color == Color(1, 0, 0));
    REQUIRE(scene.planes.size() == 1);
    CHECK(scene.planes[0].shape.point == Vec3(0, 0, -10));
    CHECK(scene.planes[0].shape.normal == Vec3(0, 1, 0));
    REQUIRE(scene.cylinders.size() == 1);
    CHECK(scene.cylinders[0].shape.center == Vec3(50, 0, Real(20.6)));
    CHECK(scene.cylinders[0].shape.axis == Vec3(0, 0, 1));
    CHECK(nearly(scene.cylinders[0].shape.radius, Real(7.1)));
    CHECK(scene.cylinders[0].shape.height == Real(21.42));
}

TEST_CASE("the old dialect: R A c l sp pl sq cy tr") {
    const Scene scene = strict(
        "R 1920 1080\n"
        "A 0.2 255,255,255\n"
        "c -50,0,20 0,0,1 70\n"
        "c 50,0,20 0,0,-1 70\n"
        "l -40,0,30 0.7 255,255,255\n"
        "l 40,0,30 0.7 255,255,255\n"
        "sq 0,100,40 0,0,1 30 42,42,0\n"
        "tr 10,20,10 10,10,20 20,10,10 0,0,255\n");
    CHECK(scene.resolution.width == 1920);
    CHECK(scene.resolution.height == 1080);
    REQUIRE(scene.cameras.size() == 2);
    CHECK(scene.cameras[1].position == Vec3(50, 0, 20));
    CHECK(scene.lights.size() == 2);
    REQUIRE(scene.squares.size() == 1);
    CHECK(scene.squares[0].shape.center == Vec3(0, 100, 40));
    CHECK(scene.squares[0].shape.side == 30);
    CHECK_FALSE(scene.squares[0].shape.one_sided);
    REQUIRE(scene.triangles.size() == 1);
    CHECK(scene.triangles[0].shape.a == Vec3(10, 20, 10));
    CHECK(scene.triangles[0].shape.b == Vec3(10, 10, 20));
    CHECK(scene.triangles[0].shape.c == Vec3(20, 10, 10));
    CHECK(scene.triangles[0].material.color == Color(0, 0, 1));
}

TEST_CASE("both dialects in one scene") {
    const Scene scene =
        strict("R 8 6\nC 0,0,0 0,0,-1 60\nl 0,1,0 1 255,255,255\ntr 0,0,-5 1,0,-5 0,1,-5 1,2,3\n");
    CHECK(scene.cameras.size() == 1);
    CHECK(scene.lights.size() == 1);
    CHECK(scene.triangles.size() == 1);
}

TEST_CASE("a cone: apex, direction, diameter, height, color") {
    const Scene scene = strict(camera + "co 1,2,3 0,-1,0 4 5 255,255,0\n");
    REQUIRE(scene.cones.size() == 1);
    CHECK(scene.cones[0].shape.apex == Vec3(1, 2, 3));
    CHECK(scene.cones[0].shape.axis == Vec3(0, -1, 0));
    CHECK(scene.cones[0].shape.radius == 2);
    CHECK(scene.cones[0].shape.height == 5);
    CHECK(scene.cones[0].material.color == Color(1, 1, 0));
}

TEST_CASE("the sky: its color straight down, its color straight up") {
    const Scene scene = strict(camera + "sky 255,51,0 0,102,255\n");
    REQUIRE(scene.sky);
    CHECK(scene.sky->bottom == Color(1, Real(0.2), 0));
    CHECK(scene.sky->top == Color(0, Real(0.4), 1));
    CHECK_FALSE(strict(camera).sky);
}

TEST_CASE("a camera alone is a scene: no R, no A, no light") {
    const Scene scene = strict(camera);
    CHECK(scene.resolution.width == 640);
    CHECK(scene.resolution.height == 480);
    CHECK_FALSE(scene.ambient);
    CHECK(scene.lights.empty());
    CHECK(scene.cameras[0].fov_axis == FovAxis::vertical);
    CHECK(nearly(scene.cameras[0].fov, pi / 3));
}

TEST_CASE("several lights are fine in either dialect") {
    const Scene scene = strict(camera + "L 0,1,0 0.5 255,255,255\nL 0,2,0 0.5 255,255,255\n");
    CHECK(scene.lights.size() == 2);
}

TEST_CASE("numbers: signs, leading zeros, no digit before or after the point") {
    const Scene scene = strict(camera + "sp +1,-.5,007. 00002.50 +255,000,1\n");
    const Sphere shape = scene.spheres.at(0).shape;
    CHECK(shape.center == Vec3(1, Real(-0.5), 7));
    CHECK(shape.radius == Real(1.25));
}

TEST_CASE("a number nearer to zero than any Real is zero") {
    const std::string tiny = "0." + std::string(400, '0') + "1";
    CHECK(strict(camera + "sp " + tiny + ",-" + tiny + ",0 1 0,0,0\n").spheres.at(0).shape.center ==
          Vec3(0));
}

TEST_CASE("the field of view is in degrees, 0 and 180 included, and its half has a tangent") {
    const auto fov = [](const std::string& degrees) {
        return strict("C 0,0,0 0,0,-1 " + degrees + "\n").cameras.at(0).fov;
    };
    CHECK(fov("0") == 0);
    CHECK(nearly(fov("45"), pi / 4));
    CHECK(nearly(fov("180"), pi));
    CHECK(std::tan(fov("180") / 2) > 1000);
}

TEST_CASE("vertical_fov") {
    const Resolution wide{.width = 200, .height = 100};
    Camera given{.position = Vec3(0), .direction = {0, 0, -1}, .fov = pi / 2};
    CHECK(vertical_fov(given, wide) == given.fov);
    // tan 45° = 1 across the width, so 1/2 across the height: 2 · atan(1/2) = atan(4/3).
    given.fov_axis = FovAxis::horizontal;
    CHECK(nearly(vertical_fov(given, wide), std::atan2(Real(4), Real(3))));
    CHECK(nearly(vertical_fov(given, {.width = 7, .height = 7}), pi / 2));
}

TEST_CASE("directions are made unit length") {
    SECTION("3, 4, 5") {
        const Scene scene =
            lenient(camera + "pl 0,0,0 0,3,4 1,2,3\ncy 0,0,0 0,0,-9 1 1 1,2,3\n").scene;
        CHECK(nearly(scene.planes[0].shape.normal, Vec3(0, Real(0.6), Real(0.8))));
        CHECK(scene.cylinders[0].shape.axis == Vec3(0, 0, -1));
    }
    SECTION("in strict reading too, with components from -1 to 1") {
        const Scene scene = strict("C 0,0,0 -.03,0,.04 60\n");
        CHECK(nearly(scene.cameras[0].direction, Vec3(Real(-0.6), 0, Real(0.8))));
    }
    SECTION("so long or short that a square over- or underflows") {
        const std::string large = "1" + std::string(30, '0');
        const std::string small = "0." + std::string(30, '0') + "1";
        const Vec3 diagonal = Vec3(1, -1, 0) / std::sqrt(Real(2));
        for (const std::string& size : {large, small}) {
            const Scene scene =
                lenient(camera + "pl 0,0,0 " + size + ",-" + size + ",0 1,2,3\n").scene;
            CHECK(nearly(scene.planes[0].shape.normal, diagonal));
        }
    }
}

TEST_CASE("a camera whose direction is zero looks along an axis to most shapes, with a warning") {
    const auto looks = [](const std::string& shapes, const std::string& axis) {
        const std::string text = "C 1,2,3 0,0,0 60\n" + shapes;
        const Lenient read = lenient(text);
        CHECK(read.warnings ==
              std::vector<std::string>{
                  "scene.rt:1:1: warning: a camera's direction is zero: it points along " + axis +
                  ", the axis nearest to most shapes"});
        CHECK(strict(text).cameras.at(0).direction == read.scene.cameras.at(0).direction);
        return read.scene.cameras.at(0).direction;
    };
    CHECK(looks("", "0,0,-1") == Vec3(0, 0, -1));
    CHECK(looks("pl 0,0,9 0,0,1 1,2,3\n", "0,0,-1") == Vec3(0, 0, -1));
    CHECK(looks("sp 1,2,3 1 1,2,3\n", "0,0,-1") == Vec3(0, 0, -1));  // the camera's position
    CHECK(looks("sp 10,3,4 1 1,2,3\n", "1,0,0") == Vec3(1, 0, 0));
    CHECK(looks("cy -10,3,4 0,1,0 1 1 1,2,3\n", "-1,0,0") == Vec3(-1, 0, 0));
    CHECK(looks("sq 1,10,3 0,1,0 1 1,2,3\n", "0,1,0") == Vec3(0, 1, 0));
    CHECK(looks("tr 0,-9,3 1,-9,3 2,-9,3 1,2,3\n", "0,-1,0") == Vec3(0, -1, 0));
    CHECK(looks("co 1,2,10 0,0,1 1 1 1,2,3\n", "0,0,1") == Vec3(0, 0, 1));
    CHECK(looks("sp 1,2,-10 1 1,2,3\n", "0,0,-1") == Vec3(0, 0, -1));
    // Two against one that is farther away; and as many each.
    CHECK(looks("sp 9,2,3 1 1,2,3\nsp 9,3,3 1 1,2,3\nsp 1,2,99 1 1,2,3\n", "1,0,0") ==
          Vec3(1, 0, 0));
    CHECK(looks("sp 1,2,-9 1 1,2,3\nsp 9,3,3 1 1,2,3\n", "0,0,-1") == Vec3(0, 0, -1));
    // In the scene's own coordinates.
    CHECK(looks("sp 1,2,10 1 1,2,3\n# rt: up=z\n", "0,0,1") == Vec3(0, 1, 0));
    CHECK(looks("sp 9,2,3 1 1,2,3\n# rt: hand=left\n", "1,0,0") == Vec3(-1, 0, 0));
}

TEST_CASE("a shape whose direction is zero is left out, with a warning") {
    for (const std::string line :
         {"pl 0,0,0 0,0,0 1,2,3", "sq 0,0,0 0,-0,0 1 1,2,3", "cy 0,0,0 0,0,0 1 1 1,2,3",
          "co 0,0,0 0,0,0. 1 1 1,2,3", "box 0,0,0 0,0,0 1,1,1 1,2,3",
          "mesh a.off 0,0,0 1 1,2,3 dir:0,0,0"}) {
        const Lenient read = lenient(camera + line + "\nsp 0,0,0 1 1,2,3\n");
        REQUIRE(read.warnings.size() == 1);
        CHECK(read.warnings[0].ends_with(
            "is zero: expected a direction such as 0,1,0; the shape is left out"));
        CHECK(read.scene.spheres.size() == 1);
        CHECK(read.scene.mesh_requests.empty());
        for_each_kind(read.scene,
                      []<class Shape>([[maybe_unused]] const PrimitiveList<Shape>& primitives) {
                          if constexpr (!std::is_same_v<Shape, Sphere>) CHECK(primitives.empty());
                      });
    }
}

TEST_CASE("hand=left exchanges left and right, up=z turns z upwards") {
    const std::string text =
        "C 1,2,3 0,0.6,0.8 60\nL 4,5,6 1\nsp 1,2,3 2 1,2,3\ntr 1,2,3 4,5,6 7,8,9 1,2,3\n"
        "pl 1,2,3 0,0.6,0.8 1,2,3\nmesh a.off 1,2,3 1 1,2,3\nsq 1,2,3 1,0,0 2 1,2,3\n";
    const auto check = [](const Scene& scene, auto ours) {
        CHECK(scene.cameras[0].position == ours(Vec3(1, 2, 3)));
        CHECK(scene.cameras[0].direction == ours(unit(Vec3(0, Real(0.6), Real(0.8)))));
        CHECK(scene.lights[0].position == ours(Vec3(4, 5, 6)));
        CHECK(scene.spheres[0].shape.center == ours(Vec3(1, 2, 3)));
        CHECK(scene.triangles[0].shape.c == ours(Vec3(7, 8, 9)));
        CHECK(scene.planes[0].shape.normal == ours(unit(Vec3(0, Real(0.6), Real(0.8)))));
        CHECK(scene.squares[0].shape.basis.z == ours(Vec3(1, 0, 0)));
        const Transform& placement = scene.mesh_requests[0].placement;
        CHECK(placement.translation == ours(Vec3(1, 2, 3)));
        CHECK(rotated(Vec3(1, 2, 3), placement) == ours(Vec3(1, 2, 3)));
    };
    const auto as_it_is = [](Vec3 v) { return v; };
    const auto mirrored = [](Vec3 v) { return Vec3(-v.x, v.y, v.z); };
    const auto turned_up = [](Vec3 v) { return Vec3(v.x, v.z, -v.y); };
    const auto both = [](Vec3 v) { return Vec3(-v.x, v.z, -v.y); };
    check(lenient(text).scene, as_it_is);
    check(lenient("# rt: hand=left\n" + text).scene, mirrored);
    check(lenient("# rt: up=z\n" + text).scene, turned_up);
    check(lenient(text + "# rt: up=z hand=left\n").scene, both);
    check(lenient(text, {.axes = {.left_handed = true, .z_up = true}}).scene, both);
    check(lenient(text + "# rt: up=y hand=right\n", {.axes = {.left_handed = true, .z_up = true}})
              .scene,
          as_it_is);
    // A point of the scene gets the same coordinates back.
    for (const bool left_handed : {false, true})
        for (const bool z_up : {false, true}) {
            const Axes axes{.left_handed = left_handed, .z_up = z_up};
            CHECK(to_its_axes(to_our_axes(Vec3(1, 2, 3), axes), axes) == Vec3(1, 2, 3));
        }
}

TEST_CASE("a square lies in the x and y of the basis around its normal") {
    const Square square = strict(camera + "sq 0,0,0 0,0,-1 2 1,2,3\n").squares.at(0).shape;
    CHECK(square.basis.z == Vec3(0, 0, -1));
    CHECK(square.basis.x == Vec3(-1, 0, 0));  // (0, 1, 0) × z
    CHECK(square.basis.y == Vec3(0, 1, 0));
}

TEST_CASE("a square is seen from both sides, or with sides:1 from one") {
    const auto one_sided = [](const std::string& option) {
        return strict(camera + "sq 0,0,0 0,0,1 2 1,2,3" + option + "\n")
            .squares.at(0)
            .shape.one_sided;
    };
    CHECK_FALSE(one_sided(""));
    CHECK(one_sided(" sides:1"));
    CHECK_FALSE(one_sided(" sides:2"));
}

TEST_CASE("a cylinder's position is its center, or with cyl=base the middle of its base") {
    const std::string line = "cy 1,2,3 0,1,0 2 10 1,2,3\n";
    const auto center = [](const Scene& scene) { return scene.cylinders.at(0).shape.center; };
    const SceneReading from_base{.strict = true, .cylinder_from_base = true};
    CHECK(center(strict(camera + line)) == Vec3(1, 2, 3));
    CHECK(center(strict(camera + "# rt: cyl=base\n" + line)) == Vec3(1, 7, 3));
    CHECK(center(parse_scene(camera + line, "", orthonormal_basis, from_base)) == Vec3(1, 7, 3));
    CHECK(center(parse_scene(camera + line + "# rt: cyl=center\n", "", orthonormal_basis,
                             from_base)) == Vec3(1, 2, 3));
}

TEST_CASE("an early revision has a cylinder's color in third place") {
    const Scene scene = strict(camera + "cy 1,2,3 0,0,1 255,51,0 14 21\n");
    REQUIRE(scene.cylinders.size() == 1);
    CHECK(scene.cylinders[0].shape.radius == 7);
    CHECK(scene.cylinders[0].shape.height == 21);
    CHECK(scene.cylinders[0].material.color == Color(1, Real(0.2), 0));
}

TEST_CASE("# rt: on any line says how the whole file is meant") {
    const Scene scene = strict(camera + "c 0,0,0 0,0,-1 60\nR 4 4\n#rt: cyl=base\tfov=horizontal");
    CHECK(scene.cameras[0].fov_axis == FovAxis::horizontal);
    CHECK(scene.cameras[1].fov_axis == FovAxis::horizontal);
    const SceneReading horizontal{.fov_axis = FovAxis::horizontal};
    CHECK(parse_scene(camera, "", orthonormal_basis, horizontal).cameras[0].fov_axis ==
          FovAxis::horizontal);
    CHECK(parse_scene("# rt: fov=vertical\n" + camera, "", orthonormal_basis, horizontal)
              .cameras[0]
              .fov_axis == FovAxis::vertical);
}

TEST_CASE("comments: #, also behind a word, and // where a word begins") {
    const Scene scene = strict(
        "# sp 0,0,0 1 1,2,3\n"
        "//sp 0,0,0 1 1,2,3\n"
        "  \t# indented\n"
        "C 0,0,0 0,0,-1 60# glued\n"
        "sp 0,0,0 2 1,2,3 // behind\n"
        "sp 0,0,0 4 1,2,3 #\n");
    CHECK(scene.spheres.size() == 2);
}

TEST_CASE("lines: tabs, CRLF, indents, empty ones, a byte order mark, no final newline") {
    const Scene scene = strict(
        "\xEF\xBB\xBFR\t8\t6\r\n\r\n \t \r\n  C\t0,0,0\t \t0,0,-1\t60\t\r\nsp 0,0,0 1 1,2,3");
    CHECK(scene.resolution.width == 8);
    CHECK(scene.cameras.size() == 1);
    CHECK(scene.spheres.size() == 1);
    CHECK(strict("R 8 6\rC 0,0,0 0,0,-1 60 # CR\rsp 0,0,0 1 1,2,3\r").spheres.size() == 1);
    std::string long_text = "C 0,0,0 0,0,-1 60\r";
    while (long_text.size() < 20'000) long_text += "sp 0,0,0 1 1,2,3\r";
    CHECK(strict(long_text).spheres.size() > 1000);
}

TEST_CASE("a side above 8192 pixels is clipped, with a warning") {
    const auto read = lenient("R 8192 10000\n" + camera);
    CHECK(read.scene.resolution.width == 8192);
    CHECK(read.scene.resolution.height == 8192);
    CHECK(read.warnings ==
          std::vector<std::string>{
              "scene.rt:1:8: warning: the resolution's height is clipped from \"10000\" to 8192"});
    const Scene scene = strict("R " + std::string(300, '9') + " 8193\n" + camera);
    CHECK(scene.resolution.width == 8192);
    CHECK(scene.resolution.height == 8192);
}

TEST_CASE("a scene's square has the basis of stage 2 around its normal (MRT §6)") {
    const Scene scene = strict("C 0,0,5 0,0,-1 60\nsq 0,0,0 0.6,0,0.8 2 255,255,255\n");
    const Square& square = scene.squares.at(0).shape;
    CHECK(gives("X", square.basis.x, Vec3(Real(0.8), 0, Real(-0.6))));
    CHECK(gives("Y", square.basis.y, Vec3(0, 1, 0)));
    CHECK(gives("Z", square.basis.z, Vec3(Real(0.6), 0, Real(0.8))));
}
