// Stage 9, pictures with several lights, against CR §3.1.
#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"

#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

using namespace rt;

namespace {

Color seen(const Scene& scene, const Ray& ray, PhongTerm term = PhongTerm::all) {
    Context context;
    context.settings.term = term;
    return trace(scene, ray, context);
}

/// The plane z = 0 with a highlight, seen along -z or +z, in ambient light of 1/8.
Scene wall() {
    Scene scene;
    scene.ambient = Ambient{.ratio = Real(0.125)};
    scene.planes.push_back({.shape = {.point = {0, 0, 0}, .normal = {0, 0, 1}},
                            .material = {.specular = 1, .shininess = 2}});
    return scene;
}

const Ray from_before{.origin = {0, 0, 3}, .direction = {0, 0, -1}};
const Ray from_behind{.origin = {0, 0, -3}, .direction = {0, 0, 1}};

}  // namespace

TEST_CASE("ambient light in a scene with no light, two and three (erratum 14, CR §3.1)") {
    Scene scene = wall();
    CHECK(gives("no light", seen(scene, from_before), Color(Real(0.125))));
    scene.lights = {{.position = {0, 0, -5}}, {.position = {3, 0, -4}}};  // behind the wall
    CHECK(gives("two lights behind the wall", seen(scene, from_before), Color(Real(0.125))));
    scene.lights.push_back({.position = {4, 0, 3}});
    CHECK(
        gives("and one before it", seen(scene, from_before, PhongTerm::diffuse), Color(Real(0.6))));
    CHECK(gives("and one before it, ambient", seen(scene, from_before, PhongTerm::ambient),
                Color(Real(0.125))));
    const Ray away{.origin = {0, 0, 3}, .direction = {0, 0, 1}};
    CHECK(gives("a ray that misses everything", seen(scene, away), Color(0)));
}

TEST_CASE("several lights add up (CR §3.1)") {
    Scene scene = wall();
    scene.ambient.reset();
    scene.lights = {{.position = {3, 0, 4}, .brightness = Real(0.5), .color = {1, 0, 0}},
                    {.position = {-4, 0, 3}, .brightness = Real(0.25), .color = {0, 1, 1}}};
    CHECK(gives("diffuse, of two lights", seen(scene, from_before, PhongTerm::diffuse),
                Color(Real(0.4), Real(0.15), Real(0.15))));
    CHECK(gives("specular, of two lights", seen(scene, from_before, PhongTerm::specular),
                Color(Real(0.32), Real(0.09), Real(0.09))));
    CHECK(gives("together", seen(scene, from_before), Color(Real(0.72), Real(0.24), Real(0.24))));
}

TEST_CASE("a surface has two sides, and a light shows the one it is on (contract)") {
    Scene scene = wall();
    const Color ambient(Real(0.125));
    for (const Real side : {Real(1), Real(-1)}) {
        scene.lights = {{.position = {3, 0, 4 * side}}};
        const Color full = Color(Real(0.8) + Real(0.64)) + ambient;
        CHECK(gives("the wall from before, light at z = " + text(4 * side),
                    seen(scene, from_before), side > 0 ? full : ambient));
        CHECK(gives("the wall from behind, light at z = " + text(4 * side),
                    seen(scene, from_behind), side > 0 ? ambient : full));
    }
    Scene bubble;
    bubble.spheres.push_back({.shape = {.center = {0, 0, 0}, .radius = 1}});
    bubble.lights = {{.position = {0, 0, Real(0.5)}}};
    CHECK(gives("a sphere with a light in it, from inside",
                seen(bubble, {.origin = {0, 0, 0}, .direction = {0, 0, 1}}), Color(1)));
    CHECK(gives("a sphere with a light in it, from outside", seen(bubble, from_before), Color(0)));
}

TEST_CASE("the pictures of the three terms sum to the whole (CR §3.1)") {
    const Scene scene =
        load_scene(project_file("scenes/step09_phong.rt"), orthonormal_basis, {.strict = true});
    const auto ray_through = pixel_rays(scene.cameras.front(), scene.resolution);
    for (Pixel pixel; pixel.row < scene.resolution.height; pixel.row += 48)
        for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += 48) {
            const Ray ray = ray_through(pixel);
            const Verdict sum =
                gives("ambient + diffuse + specular of --pixel " + std::to_string(pixel.row) + "," +
                          std::to_string(pixel.column),
                      seen(scene, ray, PhongTerm::ambient) + seen(scene, ray, PhongTerm::diffuse) +
                          seen(scene, ray, PhongTerm::specular),
                      seen(scene, ray));
            if (!sum) CHECK(sum);
        }
    CHECK(picture_matches("step09_phong_ambient",
                          {.scene = "step09_phong", .settings = {.term = PhongTerm::ambient}}));
    CHECK(picture_matches("step09_phong_diffuse",
                          {.scene = "step09_phong", .settings = {.term = PhongTerm::diffuse}}));
    CHECK(picture_matches("step09_phong_specular",
                          {.scene = "step09_phong", .settings = {.term = PhongTerm::specular}}));
}

TEST_CASE("the picture of the stage (CR §3.1)") {
    CHECK(picture_matches("step09_phong"));
}
