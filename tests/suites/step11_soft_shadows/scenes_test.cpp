// Soft shadows in scenes, and their sampling, against CR §3.3 and erratum 16.
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"

#include "tests/kit/light.hpp"
#include "tests/kit/picture.hpp"
#include "tests/suites/step11_soft_shadows/share_of_light.hpp"

#include "common/contract/light_points.hpp"
#include "common/contract/rendered.hpp"
#include "common/image/png.hpp"
#include "common/render/render.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step08_cone/all_shapes.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step11_soft_shadows/lighting.hpp"

#include <algorithm>

using namespace rt;

namespace {

// Scenes for the whole stage: a light above the ground, and half-way a strip |x| < 1, endless along
// z (erratum 16).

constexpr const char* strip =
    "C 0,1,5 0,0,-1 60\nA 0.2 255,255,255\n"
    "tr -1,2,-900 1,2,-900 1,2,900 255,255,255\ntr -1,2,-900 1,2,900 -1,2,900 255,255,255\n";

Scene scene_of(const std::string& lights) {
    return parse_scene(strip + lights, "strip.rt", orthonormal_basis, {.strict = true});
}

/// White ground at y = 0, seen from above.
ShadingPoint ground(Real x) {
    return {.point = {x, 0, 0},
            .normal = {0, 1, 0},
            .geometric_normal = {0, 1, 0},
            .to_eye = {0, 1, 0},
            .error = 64 * unit_roundoff * (1 + std::abs(x))};
}

/// The share of the first light that passes the strip.
double free_share(const Light& light, Real x) {
    const auto edge = [x](double at) { return normalize(Exact(2, x - at, 0)); };  // points to +x
    return share_beside_plane(light, {x, 0, 0}, edge(1)) +
           share_beside_plane(light, {x, 0, 0}, -edge(-1));
}

struct Lit {
    PhongTerms terms;
    std::int64_t rays;
};

bool is_blocked(const Scene& scene, const ShadowRay& way) {
    Context context;
    AnyHit any_hit(way.ray, way.interval, context);
    visit_shapes(any_hit, scene);
    return any_hit.found();
}

Lit lit(const Scene& scene, Real x, const RenderSettings& settings, Pixel pixel = {},
        double weight = 1) {
    Context context{.settings = settings, .pixel = pixel, .weight = weight};
    const auto obstacles = [&](auto& query) { visit_shapes(query, scene); };
    const PhongTerms terms = lighting(scene, ground(x), obstacles, context);
    return {.terms = terms, .rays = context.sized_light_rays};
}

/// The mean, over 64 seeds, of the share that 256 rays find.
Real mean_share(const Scene& scene, Real x) {
    Real sum = 0;
    for (std::uint32_t i = 0; i < 64; ++i) {
        ShadowRays rays{.sent = 256};
        for (const Vec3& point : light_points(scene.lights[0], {x, 0, 0}, i, rays.sent))
            if (!is_blocked(scene, shadow_ray(ground(x), point))) ++rays.reached;
        sum += visibility(rays);
    }
    return sum / 64;
}

/// The mean color, 0 to 255, of 8 × 8 pixels.
Exact mean_color(const Image& image, Pixel corner) {
    Exact sum(0);
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column) {
            const Rgb color = image[{corner.row + row, corner.column + column}];
            sum += Exact(color[0], color[1], color[2]);
        }
    return sum / 64.0;
}

/// Like picture_matches, but another right sample_light assigns other points to the samples, which
/// makes another noise: means of 8 × 8 pixels of a small picture are compared. The error of a pixel
/// in the penumbra is some 5 of 255 (16 rays), that of a mean an eighth of it, and two means differ
/// by less than 6 of 255.
Verdict picture_matches_on_average(const std::string& name) {
    const Image reference = read_png(project_file("docs/pictures/small/" + name + ".png"));
    Scene scene =
        load_scene(project_file("scenes/" + name + ".rt"), orthonormal_basis, {.strict = true});
    build_acceleration(scene);
    scene.resolution = reference.resolution;
    const Image image = rendered(scene);
    int different = 0;
    std::string first;
    for (Pixel corner; corner.row + 8 <= reference.resolution.height; corner.row += 8)
        for (corner.column = 0; corner.column + 8 <= reference.resolution.width;
             corner.column += 8) {
            const Exact got = mean_color(image, corner);
            const Exact expected = mean_color(reference, corner);
            const Exact off = abs(got - expected);
            if (std::max({off.x, off.y, off.z}) < 6 || different++ > 0) continue;
            const std::string place =
                std::to_string(corner.row + 4) + "," + std::to_string(corner.column + 4);
            first = "\n  first:    around row,column " + place +
                    "\n  got:      " + text(Vec3(got)) + "\n  expected: " + text(Vec3(expected)) +
                    "\n  see:      ./course run " + name + " --size 128x96 --pixel " + place;
        }
    return verdict(different == 0, "The picture of scenes/" + name + ".rt differs in " +
                                       std::to_string(different) +
                                       " places of 8 x 8 pixels, on the average of each." + first);
}

}  // namespace

TEST_CASE("the penumbra's place and darkness on both sides of the shadow's edge (erratum 16)",
          "[part together]") {
    const Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:2\n");
    for (const Real x : {Real(0.5), Real(1), Real(1.5), Real(2), Real(3)}) {
        const Real expected = Real(free_share(scene.lights[0], x));
        for (const Real side : {x, -x}) {
            const Real got = mean_share(scene, side);
            CHECK(verdict(std::abs(got - expected) < Real(share_bound),
                          "The share of a light of radius 2, four above the ground, beside a strip "
                          "two wide half-way, at x = " +
                              text(side) + "\n  got:      " + text(got) + "\n  expected: " +
                              text(expected) + " at x and at -x, give or take 0.0102"));
        }
    }
}

TEST_CASE("the colors in the umbra and in full light (CR §3.3)") {
    // Radius 0.5: from the middle it fills 7 degrees, and the strip 26.
    const Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:0.5\n");
    for (const Real x : {Real(0), Real(0.75), Real(-0.75), Real(1.25)}) {
        const PhongTerms terms = lit(scene, x, {}).terms;
        CHECK(gives("the diffuse term in the umbra", terms.diffuse, Color(0)));
        CHECK(gives("the ambient term in the umbra", terms.ambient, Color(Real(0.2))));
    }
    for (const Real x : {Real(4), Real(-4)}) {
        const PhongTerms terms = lit(scene, x, {}).terms;
        CHECK(gives("the diffuse term in full light", terms.diffuse,
                    diffuse_term(ground(x), scene.lights[0])));
    }
}

TEST_CASE("lights add up, in any order (CR §3.3, erratum 16)") {
    // At x = 4 the strip hides all of the first light and nothing of the second.
    const std::string hidden = "L -4,4,0 0.5 255,255,255 radius:0.25\n";
    const std::string free = "L 4,4,0 0.25 255,255,255 radius:0.25\n";
    for (const std::string& lights : {hidden + free, free + hidden})
        CHECK(gives("the diffuse term", lit(scene_of(lights), 4, {}).terms.diffuse,
                    Color(Real(0.25))));
    CHECK(gives("the diffuse term", lit(scene_of(free + free), 4, {}).terms.diffuse,
                Color(Real(0.5))));
}

TEST_CASE("a tolerance stops the sampling within its error (contract)") {
    const Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:2\n");
    CHECK(lit(scene, 9, {.shadow_samples = 100}).rays == 100);
    CHECK(lit(scene, 9, {.shadow_samples = 100, .shadow_error = 1e-9}).rays == 100);
    const auto spent = [&](double accepted) {
        std::int64_t rays = 0;
        double squares = 0;
        int count = 0;
        for (const Real x : {Real(0.25), Real(1), Real(2), Real(4)})
            for (int i = 0; i < 40; ++i) {
                const Lit got =
                    lit(scene, x, {.shadow_samples = 4096, .shadow_error = 255 * accepted},
                        {.row = i, .column = 7});
                const double all = diffuse_term(ground(x), scene.lights[0]).g;
                const double error = got.terms.diffuse.g - all * free_share(scene.lights[0], x);
                squares += error * error;
                rays += got.rays;
                ++count;
            }
        INFO("tolerance " << accepted << ", " << rays << " rays");
        CHECK(std::sqrt(squares / count) <= accepted);
        return rays;
    };
    const std::int64_t coarse = spent(0.02);
    const std::int64_t fine = spent(0.01);
    CHECK(coarse >= 160 * 8);
    CHECK(coarse < fine);
    CHECK(fine < 160 * 4096);
}

TEST_CASE("with a weight of a quarter the error may be four times as large (contract)") {
    Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:2\n");
    const auto rays = [&](Real x, double error, double weight) {
        return lit(scene, x, {.shadow_samples = 4096, .shadow_error = error}, {}, weight).rays;
    };
    for (const Real x : {Real(0.25), Real(1), Real(9)}) {
        CHECK(rays(x, 1, 0.25) == rays(x, 4, 1));
        CHECK(rays(x, 1, 0.25) < rays(x, 1, 1));
    }
    const auto property = [&](Random& random) {
        scene.lights[0].radius = random.between(1, 2);
        const Real x = random.between(Real(0.25), 9);
        const std::int64_t of_a_quarter = rays(x, 1, 0.25);
        const Lit whole = lit(scene, x, {.shadow_samples = 4096, .shadow_error = 1});
        const double all = diffuse_term(ground(x), scene.lights[0]).g;
        const double error = whole.terms.diffuse.g - all * free_share(scene.lights[0], x);
        const bool fewer = of_a_quarter == rays(x, 4, 1) && of_a_quarter < whole.rays;
        return verdict(
            fewer && std::abs(error) <= 16.0 / 255,  // of 1 / 255, many times
            "Expected fewer shadow rays from " + text(x) + " for a quarter of a pixel, " +
                "as many as for four times the error, not " + std::to_string(of_a_quarter) +
                "; and an error of 1 / 255, not " + text(Real(error)));
    };
    CHECK(for_all(property, 16));
}

TEST_CASE("rays that all agree end the sampling if that is enabled (contract)") {
    const Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:0.25\n");
    const RenderSettings careful{.shadow_samples = 4096, .shadow_error = 0.5};
    const RenderSettings believing{.shadow_samples = 4096, .shadow_error = 0.5, .shadow_agree = 16};
    int whole = 0;
    int partial = 0;
    for (Real x = -6; x <= 6; x += Real(0.125)) {
        const double share = free_share(scene.lights[0], x);
        const std::int64_t rays = lit(scene, x, believing).rays;
        if (share == 0 || share == 1) {
            CHECK((rays == 16 || rays == 0));  // none if the light is behind the surface
            ++whole;
        } else if (0.25 < share && share < 0.75) {
            CHECK(rays == lit(scene, x, careful).rays);
            ++partial;
        }
    }
    CHECK(whole > 10);
    CHECK(partial > 0);
}

TEST_CASE("soft shadows are the same for any number of threads (contract)") {
    Scene scene = scene_of("L 0,4,0 0.5 255,255,255 radius:1\npl 0,0,0 0,1,0 255,255,255\n");
    scene.resolution = {12, 9};
    const auto one = render(scene, {.threads = 1, .settings = {.shadow_error = 5}});
    CHECK(one->sized_light_rays > 0);
    // The message contains no numbers: with state kept between calls, they depend on the order of
    // the threads.
    for (const int threads : {2, 3, 7}) {
        const auto several = render(scene, {.threads = threads, .settings = {.shadow_error = 5}});
        CHECK((several->image.pixels == one->image.pixels));
        CHECK((several->sized_light_rays == one->sized_light_rays));
    }
}

TEST_CASE("the picture of the stage (CR §3.3)") {
    CHECK(picture_matches_on_average("step11_soft_shadows"));
}
