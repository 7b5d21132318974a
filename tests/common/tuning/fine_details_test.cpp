// What --tolerance promises of details narrower than a pixel, on scenes that the picture of stage 8
// draws: their errors are those of real pictures.
#include "common/render/render.hpp"
#include "common/tuning/auto_settings.hpp"
#include "common/tuning/render_trials.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

using namespace rt;

namespace {

constexpr Resolution picture_size{.width = 96, .height = 72};
constexpr int shapes_only = 8;

/// The side of a pixel at the distance of the shapes, which are in the plane z = 0.
const Real pixel_side = Real(0.1);

/// A wall of this gray behind z = 0, seen from z = 10.
Scene wall(Real gray = Real(0.2)) {
    Scene scene{.resolution = picture_size};
    const Real half = pixel_side * picture_size.height / 2;
    scene.cameras.push_back({.position = {0, 0, 10}, .fov = 2 * std::atan(half / 10)});
    scene.planes.push_back({.shape = {{0, 0, -1}, {0, 0, 1}}, .material = {.color = Color(gray)}});
    return scene;
}

Vec3 place(Random& random) {
    const Vec2 half = pixel_side * Vec2(picture_size.width, picture_size.height) / Real(2);
    return {random.between(-half.x, half.x), random.between(-half.y, half.y), 0};
}

/// Grains of this diameter in pixels.
Scene dust(Real diameter, int grains, unsigned seed) {
    Scene scene = wall();
    Random random(seed);
    for (int i = 0; i < grains; ++i)
        scene.spheres.push_back(
            {.shape = {place(random), diameter * pixel_side / 2}, .material = {}});
    return scene;
}

/// Cylinders of this diameter in pixels, across the picture.
Scene threads(Real diameter, int count, unsigned seed) {
    Scene scene = wall();
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const Real angle = random.between(0, pi);
        scene.cylinders.push_back({.shape = {.center = place(random),
                                             .axis = {std::cos(angle), std::sin(angle), 0},
                                             .radius = diameter * pixel_side / 2,
                                             .height = 12},
                                   .material = {}});
    }
    return scene;
}

/// Dark slats before a bright wall, with slits of this width in pixels between them.
Scene slits(Real width, unsigned seed) {
    Scene scene = wall(1);
    Random random(seed);
    const Real tilt = random.between(Real(0.1), Real(0.6));
    const Real pitch = Real(5.3) * pixel_side;
    for (Real y = random.between(-4, Real(-3.9)); y < 4; y += pitch) {
        const Vec3 a{-6, y - tilt, 0};
        const Vec3 b{6, y + tilt, 0};
        const Vec3 up{0, pitch - width * pixel_side, 0};
        const Material dark{.color = Color(Real(0.1))};
        scene.triangles.push_back({.shape = {a, b, b + up}, .material = dark});
        scene.triangles.push_back({.shape = {a, b + up, a + up}, .material = dark});
    }
    return scene;
}

class SceneTrials : public Trials {
public:
    explicit SceneTrials(const Scene& scene) : scene_(scene) { rt::build_acceleration(scene_); }

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] Resolution resolution() const override { return scene_.resolution; }
    [[nodiscard]] SceneTraits traits() const override {
        return scene_traits(scene_, shapes_only, {});
    }
    [[nodiscard]] FineShapes fine_shapes() const override { return rt::fine_shapes(scene_); }
    [[nodiscard]] double smallest_gap() const override {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] TrialSample render_pixels(const RenderSettings& settings,
                                            const TrialRequest& request) const override {
        return rt::render_pixels(scene_, settings, request);
    }
    [[nodiscard]] TrialHistories trace_histories(const RenderSettings& settings,
                                                 const TrialRequest& request) const override {
        return rt::trace_histories(scene_, settings, request);
    }
    [[nodiscard]] TrialCenters render_centers(const RenderSettings& settings,
                                              const TrialRequest& /*request*/) override {
        centers_ = rt::render_centers(scene_, {.settings = settings});
        return {.image = &centers_->image, .rays = 1, .seconds = 1e-7};
    }

private:
    Scene scene_;
    std::optional<Rendering> centers_;
};

/// The share of the pixels that the chosen settings leave off by more than the tolerance.
double share_beyond(const Scene& scene, double tolerance) {
    SceneTrials trials(scene);
    const std::atomic<bool> going_on = false;
    const auto choice =
        choose(trials, {}, {.tolerance = tolerance}, Clock::now(), going_on).value();
    for (const std::string& reason : choice.reasons) UNSCOPED_INFO(reason);
    const auto picture = [&](const RenderSettings& settings) {
        return render(trials.scene(), {.settings = settings})->image;
    };
    const Image chosen = picture(choice.expected.settings);
    const Image right = picture({.pixel_samples = 1024});
    int beyond = 0;
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        int most = 0;
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(chosen.pixels[i][k] - right.pixels[i][k]));
        beyond += most > tolerance;
    }
    return double(beyond) / double(right.pixels.size());
}

}  // namespace

TEST_CASE("details narrower than a pixel keep the tolerance") {
    for (const unsigned seed : {1U, 2U}) {
        INFO("seed " << seed);
        CHECK(share_beyond(dust(Real(1) / 6, 900, seed), 2) <= 0.01);
        CHECK(share_beyond(slits(Real(1) / 12, seed), 2) <= 0.01);
    }
    CHECK(share_beyond(threads(Real(1) / 40, 15, 1), 2) <= 0.01);
}

TEST_CASE("the pixels of shapes narrower than a pixel are known before any ray is traced") {
    const auto part = [](const Scene& scene, int row, int column) {
        return fine_shapes(scene).parts[std::size_t(row * picture_size.width + column)];
    };
    Scene scene = wall();
    CHECK(fine_shapes(scene).parts.empty());
    // The center of the pixel in row 36, column 48: half a pixel from the middle of the picture.
    const Vec3 place{pixel_side / 2, -pixel_side / 2, 0};
    scene.spheres.push_back({.shape = {place, pixel_side}, .material = {}});
    CHECK(fine_shapes(scene).parts.empty());  // two pixels wide
    scene.spheres.push_back({.shape = {place, pixel_side / 16}, .material = {}});
    const FineShapes fine = fine_shapes(scene);
    CHECK(fine.narrowest == "sphere");
    CHECK(fine.width == Approx(0.125).epsilon(0.01));
    CHECK(std::ranges::count_if(fine.parts, [](float of) { return of < 1; }) == 1);
    // It covers π / 4 · 1/64 of the pixel, and counts as rather less.
    CHECK(part(scene, 36, 48) <= 0.0123F);
    CHECK(part(scene, 36, 48) >= 0.006F);
    // A thread through that pixel, from the left edge to the right one, and nowhere else.
    scene.cylinders.push_back({.shape = {.center = place,
                                         .axis = {1, 0, 0},
                                         .radius = pixel_side / 32,
                                         .height = 2 * pixel_side * picture_size.width},
                               .material = {}});
    for (int column = 0; column < picture_size.width; ++column) {
        CHECK(part(scene, 36, column) < 1);
        CHECK(part(scene, 35, column) == 1);
        CHECK(part(scene, 37, column) == 1);
    }
    CHECK(fine_shapes(scene).narrowest == "cylinder");
    scene.spheres.push_back({.shape = {{0, 0, 20}, pixel_side / 1000}, .material = {}});  // behind
    CHECK(fine_shapes(scene).narrowest == "cylinder");
}

TEST_CASE("gaps narrower than a pixel between wide shapes are known before any ray is traced") {
    // The gap is along row 36, and its middle is the middle of the row.
    const Real middle = -pixel_side / 2;
    const Real side = 4;
    const auto add_square = [side](Scene& scene, Real x, Real y, Real z = 0) {
        scene.squares.push_back({.shape = {.center = {x, y, z}, .side = side}, .material = {}});
    };
    const auto with_gap = [&](Real width) {
        Scene scene = wall(1);
        add_square(scene, 0, middle + (side + width * pixel_side) / 2);
        add_square(scene, 0, middle - (side + width * pixel_side) / 2);
        return scene;
    };
    const auto marked = [](const Scene& scene) {
        const FineShapes fine = fine_shapes(scene);
        return std::ranges::count_if(fine.parts, [](float of) { return of < 1; });
    };
    const FineShapes fine = fine_shapes(with_gap(Real(1) / 12));
    CHECK(fine.narrowest == "gap beside a square");
    CHECK(fine.width == Approx(1. / 12).epsilon(0.01));
    for (int column = 29; column < 67; ++column)  // its ends are open to the sides
        CHECK(fine.parts[std::size_t(36 * picture_size.width + column)] ==
              Approx(1. / 24).epsilon(0.01));
    CHECK(marked(with_gap(0)) == 0);           // an edge of both
    CHECK(marked(with_gap(Real(-0.2))) == 0);  // they overlap
    CHECK(marked(with_gap(Real(1.5))) == 0);   // wide enough to be seen
    // A square behind the gap does not close it.
    Scene scene = with_gap(Real(1) / 12);
    add_square(scene, 0, 0, -1);
    CHECK(marked(scene) >= 36);
    // Triangles that share edges, as those of a mesh do, have no gap between them.
    Scene fan = wall(1);
    const Vec3 hub{Real(0.03), Real(0.02), 0};
    for (int i = 0; i < 12; ++i) {
        const auto spoke = [hub](int k) {
            const Real angle = Real(k % 12) * pi / 6;
            return hub + Real(3) * Vec3(std::cos(angle), std::sin(angle), 0);
        };
        fan.triangles.push_back({.shape = {hub, spoke(i), spoke(i + 1)}, .material = {}});
    }
    CHECK(marked(fan) == 0);
    // Two spheres that nearly touch: only there.
    Scene two = wall(1);
    for (const Real side_of : {Real(-1), Real(1)})
        two.spheres.push_back(
            {.shape = {{side_of * Real(1.001), middle, 0}, Real(1)}, .material = {}});
    CHECK(marked(two) > 0);
    CHECK(marked(two) < 12);
    CHECK(fine_shapes(two).narrowest == "gap beside a sphere");
    // Boards that begin behind the camera.
    Scene boards = wall(1);
    boards.cameras.front() = {.position = {0, 1, 10}, .fov = 1};
    for (int i = 0; i < 2; ++i) {
        const Real x = Real(i) * 2 - 2;
        const Vec3 a{x, 0, 20};
        const Vec3 b{x + Real(1.999), 0, 20};
        const Vec3 away{0, 0, -25};
        boards.triangles.push_back({.shape = {a, b, b + away}, .material = {}});
        boards.triangles.push_back({.shape = {a, b + away, a + away}, .material = {}});
    }
    CHECK(fine_shapes(boards).narrowest == "gap beside a triangle");
    Scene aside = wall(1);  // a square of 20 pixels, of which the camera sees the side
    aside.squares.push_back({.shape = {.center = {0, middle, 0},
                                       .basis = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                       .side = 2},
                             .material = {}});
    CHECK(fine_shapes(aside).narrowest == "square");
    CHECK(fine_shapes(aside).width < 0.2);
}
