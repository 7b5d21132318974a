// Stage 10, shadows in scenes, against CR §3.2, its black shadows put right, and M1's exercise.
#include "common/render/stage.hpp"

#include "tests/kit/for_all.hpp"
#include "tests/kit/picture.hpp"

using namespace rt;

namespace {

/// The color seen along the ray, as in main.cpp.
Color color_along(const Scene& scene, const Ray& ray) {
    Context context;
    return trace(scene, ray, context);
}

/// A white floor, and a ball above the origin.
Scene ball_above_floor() {
    Scene scene;
    scene.ambient = Ambient{.ratio = Real(0.25), .color = {1, 1, 1}};
    scene.planes.push_back({.shape = {.point = {0, 0, 0}, .normal = {0, 1, 0}}, .material = {}});
    scene.spheres.push_back({.shape = {.center = {0, 2, 0}, .radius = 1}, .material = {}});
    return scene;
}

/// From aside to the origin, under the ball.
const Ray to_the_origin{.origin = {4, 1, 1}, .direction = {-4, -1, -1}};

}  // namespace

TEST_CASE("a point in shadow has its ambient term (erratum 15, CR §3.2)", "[part together]") {
    Scene scene = ball_above_floor();
    scene.lights = {Light{.position = {0, 8, 0}, .brightness = Real(0.5)}};
    CHECK(gives("the color under the ball", color_along(scene, to_the_origin), Color(Real(0.25))));
    scene.spheres = {};
    CHECK(
        gives("the color without the ball", color_along(scene, to_the_origin), Color(Real(0.75))));
    CHECK(for_all([](Random& random) {
        const Real brightness = random.between(Real(0.1), Real(0.7));
        Scene random_scene = ball_above_floor();
        random_scene.lights = {
            {.position = {0, random.between(4, 64), 0}, .brightness = brightness}};
        const bool lit = random.coin();
        if (lit) random_scene.spheres = {};
        return gives(lit ? "the color without the ball" : "the color under the ball",
                     color_along(random_scene, to_the_origin),
                     Color(Real(0.25) + (lit ? brightness : 0)));
    }));
}

TEST_CASE("two lights, of which one is occluded (CR §3.2, M1)") {
    Scene scene = ball_above_floor();
    const Light above{.position = {0, 8, 0}, .brightness = Real(0.5)};
    const Light aside{.position = {-3, 4, 0}, .brightness = Real(0.5)};  // ⟨L, N⟩ = 0.8
    const Color lit_aside(Real(0.25) + Real(0.4));
    scene.lights = {above, aside};
    CHECK(gives("the color under the ball", color_along(scene, to_the_origin), lit_aside));
    scene.lights = {aside, above};
    CHECK(gives("the color, the lights in the other order", color_along(scene, to_the_origin),
                lit_aside));
    CHECK(for_all([&](Random& random) {
        // Anywhere round the ball, further away or nearer: ⟨L, N⟩ stays 0.8.
        const Real angle = random.between(-pi, pi);
        const Vec3 way(3 * std::cos(angle), 4, 3 * std::sin(angle));
        Scene random_scene = ball_above_floor();
        random_scene.lights = {above, aside};
        random_scene.lights[0].position.y = random.between(4, 64);
        random_scene.lights[1].position = random.between(Real(0.5), 8) * way;
        if (random.coin()) std::swap(random_scene.lights[0], random_scene.lights[1]);
        return gives("the color under the ball", color_along(random_scene, to_the_origin),
                     lit_aside);
    }));
}

TEST_CASE("the picture of the stage (CR §3.2)") {
    CHECK(picture_matches("step10_shadows"));
}
