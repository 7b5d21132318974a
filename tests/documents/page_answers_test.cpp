// Whole numbers and vectors in the pages' examples and answers. (Numbers with a decimal point or a
// unit are in page_numbers.hpp.)
#include "common/geometry/ray.hpp"
#include "common/image/png.hpp"
#include "common/program/load_meshes.hpp"
#include "common/render/render.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"

#include "tests/documents/page_numbers.hpp"
#include "tests/kit/inverse_matrices.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace rt;

namespace {

Scene scene_of(const std::string& name) {
    Scene scene = load_scene(project_file("scenes/" + name + ".rt"), orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    return scene;
}

}  // namespace

TEST_CASE("stage 1's example: the matrices and both points of a picture of 3 x 3 pixels") {
    const Mat4 p = glm::perspective(pi / 2, Real(1), Real(1), Real(3));
    CHECK(close(p[0][0], 1));
    CHECK(close(p[1][1], 1));
    CHECK(close(p[2][2], -2));
    CHECK(close(p[3][2], -3));
    const InverseMatrices inverse = inverse_matrices(
        Mat4(1), {.resolution = {3, 3}, .vertical_fov = pi / 2, .near_plane = 1, .far_plane = 3});
    const Real third = Real(1) / 3;
    const Vec4 on_near = inverse.image_to_world * Vec4(Real(2.5), Real(0.5), 0, 1);
    CHECK(gives("e_0", Vec3(on_near), Vec3(2 * third, 2 * third, -1)));
    CHECK(close(on_near.w, 1));
    const Vec4 on_far = inverse.image_to_world * Vec4(Real(2.5), Real(0.5), 1, 1);
    CHECK(gives("e_1 before the division", Vec3(on_far), Vec3(2 * third, 2 * third, -1)));
    CHECK(close(on_far.w, third));
    const Ray ray = unprojected_ray({0, 2}, inverse.camera_to_world, inverse.image_to_world);
    CHECK(gives("o", ray.origin, Vec3(0, 0, 0)));
    CHECK(gives("e_1", at(ray, 1), Vec3(2, 2, -3)));
    CHECK(says("step01_ray_generation", "this is $e_1 = " + text(Vec3(2, 2, -3)) + "$"));
    CHECK(close(pixel_on_screen({0, 2}, {3, 3}, pi / 2), Vec2(2 * third, 2 * third)));
    CHECK(close(pixel_on_screen({1, 1}, {3, 3}, pi / 2), Vec2(0, 0)));
}

TEST_CASE("stage 1's answers: the middle of the picture, and a field of view of 179 degrees") {
    const auto x = [](int column) { return pixel_on_screen({0, column}, {640, 480}, 1).x; };
    CHECK(x(319) < 0);
    CHECK(close(x(320), -x(319)));
    CHECK(says("step01_ray_generation", "between the columns 319 and 320."));
    const long top = std::lround(std::tan(179 * degree / 2));
    CHECK(says("step01_ray_generation", "ends " + std::to_string(top) + " above the middle."));
}

TEST_CASE("stage 2's answers: straight down, and through the vertical") {
    CHECK(gives("Y", camera_basis({0, -1, 0}).y, Vec3(0, 0, -1)));
    CHECK(says("step02_camera_basis", R"($Y = Z \wedge X = )" + text(Vec3(0, 0, -1)) + "$"));
}

TEST_CASE("stage 3's page: a sphere and a scene, both ten times as large") {
    const auto discriminant = [](Real scale) {
        const Vec3 d(0, 0, -1);
        const Vec3 from_center(0, scale, 5 * scale);
        const Real c = dot(from_center, from_center) - 4 * scale * scale;
        return 4 * (dot(d, from_center) * dot(d, from_center) - dot(d, d) * c);
    };
    CHECK(close(discriminant(10), 100 * discriminant(1)));
    CHECK(
        says("step03_sphere",
             "ten times as large, with the same direction, $\\Delta$ is a hundred times as large"));
}

TEST_CASE("stage 4's page: the implicit form of situation A's plane, and the ground's last row") {
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    CHECK(dot(plane.point, plane.normal) == 2);
    CHECK(says("step04_plane", "$3 x + 4 z - 2 = 0$ is the plane of situation A"));
    const Scene scene = scene_of("step04_plane");
    const auto rays = pixel_rays(scene.cameras.front(), scene.resolution);
    const Plane& ground = scene.planes.begin()->shape;
    Pixel pixel{.column = 320};
    while (!intersect(rays(pixel), ground, {})) ++pixel.row;
    CHECK(says("step04_plane", "it is row " + std::to_string(pixel.row) + ","));
}

TEST_CASE("stage 5's answers: weights, and a triangle without an area") {
    const Triangle triangle{.a = {0, 0, 0}, .b = {6, 0, 0}, .c = {0, 6, 0}};
    const Real half = Real(0.5);
    const Real third = Real(1) / 3;
    CHECK(gives("the middle of bc", barycentric(triangle, {3, 3, 0}), Vec3(0, half, half)));
    CHECK(gives("the center", barycentric(triangle, {2, 2, 0}), Vec3(third, third, third)));
}

TEST_CASE("stage 6's answers: what the camera sees from behind") {
    const Scene scene = scene_of("step06_square");
    const Camera& camera = scene.cameras.front();
    std::vector<Vec3> vanish;
    for (const auto& each : scene.squares) {
        const Square& square = each.shape;
        const Vec3 to_camera = camera.position - square.center;
        const bool is_ahead = dot(camera.direction, to_camera) < 0;
        if (!square.one_sided && is_ahead && dot(square.basis.z, to_camera) < 0)
            vanish.push_back(square.basis.z);
    }
    REQUIRE(vanish.size() == 2);
    CHECK(close(vanish[0], Vec3(1, 0, 0)));   // the left wall
    CHECK(close(vanish[1], Vec3(0, -1, 0)));  // the roof
    for (const auto& each : scene_of("cornell_box").squares)
        CHECK(dot(each.shape.basis.z, each.shape.center) < 0);  // into the box, around 0
}

TEST_CASE("stage 9's answer: Blinn's highlight with four times the exponent") {
    // A tenth as bright at nearly the same angle: N and H make half of the angle of R and V.
    const double phong = std::acos(std::pow(0.1, 1 / 32.0));
    const double blinn = 2 * std::acos(std::pow(0.1, 1 / 128.0));
    CHECK(std::abs(blinn / phong - 1) < 0.03);
}

TEST_CASE("stage 11's answer: the umbra of the ball ends above the ground") {
    const Scene scene = scene_of("step11_soft_shadows");
    const auto ball = std::find_if(scene.spheres.begin(), scene.spheres.end(),
                                   [](const auto& each) { return each.shape.center.y > 1; });
    REQUIRE(ball != scene.spheres.end());
    const Light& lamp = scene.lights.front();
    REQUIRE(lamp.radius > ball->shape.radius);
    const Vec3 away = ball->shape.center - lamp.position;
    const Vec3 tip =
        ball->shape.center + away * ball->shape.radius / (lamp.radius - ball->shape.radius);
    CHECK(tip.y > scene.planes.begin()->shape.point.y);
}

TEST_CASE("stage 12's answer: a pixel that shows the end of the recursion") {
    const Scene scene = scene_of("step12_mirror");
    const Pixel pixel{.row = 221, .column = 350};
    const auto seen = [&](int depth) {
        Context context{.settings = {.depth = depth}, .pixel = pixel};
        return to_rgb(
            trace(scene, pixel_rays(scene.cameras.front(), scene.resolution)(pixel), context));
    };
    const Rgb few = seen(8);
    const Rgb many = seen(30);
    int difference = 0;
    for (std::size_t i = 0; i < few.size(); ++i)
        difference = std::max(difference, std::abs(few[i] - many[i]));
    CHECK(says("step12_mirror", "by at most " + std::to_string(difference) + " of 255."));
}

TEST_CASE("stage 13's answer: boxes on the way to one of a million triangles") {
    const auto levels = [](double parts) {
        return std::to_string(int(std::ceil(std::log2(parts))));
    };
    CHECK(says("step13_meshes", levels(1e6) + ", since $2^{" + levels(1e6) + "}$ is the first"));
    CHECK(says("step13_meshes", "in the smallest boxes, " + levels(1e6 / 4) + "."));
}

TEST_CASE("the pages' Cornell boxes are what their scenes show") {
    const auto differences = [](const std::string& scene_name, const std::string& picture) {
        const Scene scene = scene_of(scene_name);
        const Image expected = read_png(project_file("docs/pictures/" + picture + ".png"));
        const auto rays = pixel_rays(scene.cameras.front(), scene.resolution);
        Context context;
        Pixel& pixel = context.pixel;
        int brighter = 0;
        int darker = 0;
        for (pixel.row = 0; pixel.row < scene.resolution.height; pixel.row += 6)
            for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += 6) {
                const Rgb got = to_rgb(trace(scene, rays(pixel), context));
                for (std::size_t i = 0; i < got.size(); ++i) {
                    brighter += expected[pixel][i] > got[i] + 1;
                    darker += expected[pixel][i] + 1 < got[i];
                }
            }
        return std::array{brighter, darker};
    };
    constexpr std::array none = {0, 0};
    CHECK(differences("cornell_phong", "cornell_shadows") == none);
    CHECK(differences("cornell_soft_shadows", "cornell_soft_shadows") == none);
    CHECK(differences("cornell_mirror", "cornell_mirror") == none);
    // Stage 9's picture of the first: without shadows, it is brighter where they are.
    const auto [brighter, darker] = differences("cornell_phong", "cornell_phong");
    CHECK(brighter > 100);
    CHECK(darker == 0);
}

TEST_CASE("antialiasing.md's answer: the shades of an upright edge in a pixel of 16 points") {
    std::set<int> regular;
    std::set<int> even;
    for (int place = 0; place <= 1000; ++place) {
        const Real edge = Real(place) / 1000;
        int left_in_grid = 0;
        int left = 0;
        for (int i = 0; i < 16; ++i) {
            left_in_grid += (Real(i % 4) + Real(0.5)) / 4 < edge;
            left += spread_sample(std::uint32_t(i), 2021).x < edge;
        }
        regular.insert(left_in_grid);
        even.insert(left);
    }
    CHECK(says("antialiasing", std::to_string(regular.size()) + " shades"));
    CHECK(says("antialiasing", "all " + std::to_string(even.size())));
}
