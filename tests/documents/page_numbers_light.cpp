// The numbers of the pages on light, shadows and mirrors.
#include "common/program/load_meshes.hpp"

#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"
#include "steps/step12_mirror/mirror.hpp"

#include "tests/documents/page_numbers.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <functional>
#include <future>
#include <random>

namespace rt {

Knowledge stage9() {
    const Vec3 n(0, 0, 1);
    const Vec3 l = normalize(Vec3(4, 0, -3));
    CHECK(std::isnan(std::pow(-0.5, 2.5)));
    Knowledge all = {{"where a cosine is 0", std::acos(0) / degree, "°"},
                     {"a power between 2 and 3", (2 + 3) / 2.0},
                     {"L", l.x},
                     {"L", l.z},
                     {"⟨R, V⟩", dot(reflected(l, n), -l)},
                     {"a step of the picture", 1 / 255.0},
                     {"the float behind 1", std::nextafter(1.0F, 2.0F)}};
    for (const double exponent : {2, 8, 32, 128, 512})
        all.push_back({"where the highlight is below one level",
                       std::acos(std::pow(255, -1 / exponent)) / degree, "°"});
    for (const double exponent : {2, 32, 512})
        all.push_back({"where the highlight is half as bright",
                       std::acos(std::pow(2, -1 / exponent)) / degree, "°"});
    return all;
}

Knowledge stage10() {
    const std::string source = "common/geometry/projection.hpp";
    const double flat_is_off =
        said_in("steps/step10_shadows/reference/shadows.cpp", "is hit up to ", " units off");
    // The ray's end before a light at distance 1, in units of u.
    const ShadingPoint floor{
        .point = {0, 0, 0}, .normal = {0, 1, 0}, .geometric_normal = {0, 1, 0}};
    const double before =
        (1 - double(shadow_ray(floor, {0, 1, 0}).interval.max)) / double(unit_roundoff);
    const double too_large =
        said_in("tests/common/render/contact_test.cpp", "{\"0", " along the normal\"");
    return {{"the least t (CR §3.2)", cr_shadow_start},
            {"u by which a point is off", said_in(source, "error of a point is at most ", ",")},
            {"where the ray ends before the ceiling, in whole degrees",
             std::ceil(std::asin(flat_is_off / before) / degree), "°"},
            {"the largest of the constants", too_large},
            {"half of it", too_large / 2}};
}

Knowledge stage12() {
    const Real m = Real(0.9);
    const int depth = RenderSettings().depth;
    const Real share = Real(0.1);
    CHECK(worth_reflecting(0, depth, share * share));
    CHECK_FALSE(worth_reflecting(0, depth, share * share * share));
    const float large = 1000000;
    CHECK(std::nextafter(large, 2 * large) - large > float(cr_mirror_start));
    return {{"the least t (CR §5.1)", cr_mirror_start},
            {"a scene too large for it", large},
            {"a mirror's share", share},
            {"after three reflections", share * share * share},
            {"the share of facing mirrors", m},
            {"what they show", 100 * (1 - std::pow(m, depth + 1)), "%"},
            {"the rest", 100 * std::pow(m, depth + 1), "%"}};
}

// The numbers of the page on soft shadows.

namespace {

const Light above{.position = {0, 4, 0}, .radius = 2};

/// The fraction of the points that pass the strip |x| < 1 two above the ground, seen from x.
double passing(double x, const std::function<Vec3(Vec3, Vec2)>& point) {
    constexpr std::uint32_t samples = 1 << 18;
    int free = 0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const Vec3 aim = point(Vec3(Real(x), 0, 0), spread_sample(i, 2021));
        if (std::abs(x + (aim.x - x) * 2 / aim.y) >= 1) ++free;
    }
    return double(free) / samples;
}

Knowledge light_shares() {
    const auto printed = [](Vec3 /*from*/, Vec2 sample) {
        return above.position + above.radius * Vec3(sample.x, sample.y, 0);
    };
    const auto flat = [](Vec3 /*from*/, Vec2 sample) {
        return above.position + above.radius * Vec3(sample.x, 0, 0);
    };
    const auto centered = [](Vec3 /*from*/, Vec2 sample) {
        return above.position + above.radius * Vec3(2 * sample.x - 1, 0, 0);
    };
    const auto sphere = [](Vec3 from, Vec2 sample) { return sample_light(above, from, sample); };
    const double x = 1.5;
    CHECK(passing(-x, printed) == 0);
    return {{"beside the strip", x},
            {"as printed", passing(x, printed)},
            {"a sphere", passing(x, sphere)},
            {"a sphere, on the other side", passing(-x, sphere)},
            {"flat, as printed", passing(x, flat)},
            {"flat, centered", passing(x, centered)}};
}

/// The ratio of the estimates to the true error for 8, 16, … 1024 rays, as root mean squares over
/// straight edges at these distances from the middle of a disc.
struct Estimates {
    std::vector<double> well_spread;  ///< true error / visibility_error
    std::vector<double> independent;  ///< √(p (1 − p) / n) / true error
};

Estimates estimates(double from, double to) {
    constexpr int edges = 10000;
    std::mt19937_64 engine(2021);
    const auto unit_interval = [&engine] { return double(engine() >> 11) * 0x1p-53; };
    std::vector<double> ratios(8);
    std::vector<double> errors(8);
    std::vector<double> independent(8);
    for (int i = 0; i < edges; ++i) {
        const double edge = from + (to - from) * unit_interval();
        const double angle = 2 * double(pi) * unit_interval();
        const double lit = 1 - (std::acos(edge) - edge * std::sqrt(1 - edge * edge)) / double(pi);
        const auto seed = std::uint32_t(engine());
        ShadowRays rays;
        for (std::size_t k = 0; k < ratios.size(); ++k) {
            for (; rays.sent < 8 << k; ++rays.sent) {
                const Vec2 sample = spread_sample(std::uint32_t(rays.sent), seed);
                const double turn = 2 * double(pi) * sample.y - angle;
                if (std::sqrt(sample.x) * std::cos(turn) < edge) ++rays.reached;
            }
            const double error = double(rays.reached) / rays.sent - lit;
            const double p = double(rays.reached + 1) / (rays.sent + 2);
            ratios[k] += std::pow(error / double(visibility_error(rays)), 2) / edges;
            errors[k] += error * error / edges;
            independent[k] += p * (1 - p) / rays.sent / edges;
        }
    }
    Estimates result;
    for (std::size_t k = 0; k < ratios.size(); ++k) {
        result.well_spread.push_back(std::sqrt(ratios[k]));
        result.independent.push_back(std::sqrt(independent[k] / errors[k]));
    }
    return result;
}

/// Stage 11's scene, 80 × 60 pixels, and its colors.
struct Drawn {
    std::vector<Color> colors;
    double rays = 0;  ///< to the lamp, a pixel
};

Drawn drawn_lamp(const RenderSettings& settings) {
    Scene scene = load_scene(project_file("scenes/step11_soft_shadows.rt"), orthonormal_basis);
    build_acceleration(scene);
    scene.resolution = {80, 60};
    const auto pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    Drawn all;
    Context context{.settings = settings};
    for (Pixel& pixel = context.pixel; pixel.row < scene.resolution.height; ++pixel.row)
        for (pixel.column = 0; pixel.column < scene.resolution.width; ++pixel.column)
            all.colors.push_back(trace(scene, pixel_ray(pixel), context));
    all.rays = double(context.sized_light_rays) / double(all.colors.size());
    return all;
}

struct Errors {
    double root_mean_square = 0;
    double largest = 0;
    std::vector<double> of_pixels;
};

Errors errors_of(const Drawn& got, const Drawn& expected) {
    Errors errors;
    double squares = 0;
    for (std::size_t i = 0; i < got.colors.size(); ++i) {
        const Color off = abs(got.colors[i] - expected.colors[i]);
        squares += dot(off, off);
        errors.of_pixels.push_back(std::max({off.r, off.g, off.b}));
        errors.largest = std::max(errors.largest, errors.of_pixels.back());
    }
    errors.root_mean_square = std::sqrt(squares / (3 * double(got.colors.size())));
    return errors;
}

/// The rows of stage 11's table.
struct Row {
    std::string option;
    RenderSettings settings;
    Drawn drawn;
    Errors errors;
};

constexpr std::size_t coarse = 4;  ///< the row of --shadow-error 2.5

std::vector<Row> soft_shadow_table() {
    auto expected =
        std::async(std::launch::async, drawn_lamp, RenderSettings{.shadow_samples = 4096});
    std::vector<Row> rows;
    for (const int samples : {16, 64, 256, 512})
        rows.push_back({.option = "--shadow-samples " + std::to_string(samples),
                        .settings = {.shadow_samples = samples}});
    for (const char* steps : {"2.5", "0.5"})
        rows.push_back({.option = std::string("--shadow-error ") + steps,
                        .settings = {.shadow_samples = most_shadow_samples,
                                     .shadow_error = std::stod(steps)}});
    for (Row& row : rows) row.drawn = drawn_lamp(row.settings);
    const Drawn right = expected.get();
    for (Row& row : rows) row.errors = errors_of(row.drawn, right);
    return rows;
}

}  // namespace

Knowledge stage11() {
    Knowledge all = light_shares();
    all.push_back({"the error of twice as many independent points", std::pow(2, -0.5)});
    all.push_back({"the error of twice as many well-spread points", std::pow(2, -0.75)});
    const std::vector<Row> table = soft_shadow_table();
    for (const Row& row : table) {
        const std::string line = "| `" + row.option + "` | " + decimals(row.drawn.rays, 1) + " | " +
                                 decimals(row.errors.root_mean_square, 4) + " | " +
                                 decimals(row.errors.largest, 3) + " |";
        CHECK(says("step11_soft_shadows", line));
        for (const Printed& number : numbers_in(line)) all.push_back({row.option, number.value});
        if (row.settings.shadow_error > 0) all.push_back({row.option, row.settings.shadow_error});
    }

    // "The same error with nine tenths of the rays at 2.5, and with seven tenths at 0.5."
    const auto errors_alike = [&table](std::size_t i, std::size_t k) {
        return std::abs(table[i].errors.root_mean_square / table[k].errors.root_mean_square - 1) <
               0.1;
    };
    CHECK(errors_alike(coarse, 1));
    CHECK(std::abs(table[coarse].drawn.rays / table[1].drawn.rays - 0.9) < 0.05);
    CHECK(errors_alike(coarse + 1, 3));
    CHECK(std::abs(table[coarse + 1].drawn.rays / table[3].drawn.rays - 0.7) < 0.05);

    // The number of pixels with an error above those 2.5 levels, to tens.
    const std::vector<double>& off = table.at(coarse).errors.of_pixels;
    const double limit = table[coarse].settings.shadow_error / 255;
    const auto beyond = [&off](double most) {
        return std::count_if(off.begin(), off.end(), [most](double error) { return error > most; });
    };
    CHECK(beyond(3 * limit) == 0);
    const double one_in = 10 * std::round(double(off.size()) / double(beyond(limit)) / 10);
    CHECK(says("step11_soft_shadows", "one pixel in " + decimals(one_in, 0) +
                                          " is off by more than $E$, and none by more than $3E$"));

    const double quarter = 4 / 16.0;
    all.push_back({"the standard error of 4 of 16 rays", std::sqrt(quarter * (1 - quarter) / 16)});

    // A light so small that floats are too coarse for its cosine.
    const double sine = 0.001;
    all.push_back({"r / D", sine});
    all.push_back({"1 − cos θ_max", 1 - std::sqrt(1 - sine * sine)});
    all.push_back({"between floats below 1", 1 - std::nextafter(1.0F, 0.0F)});
    all.push_back({"r / D of a point", sine / 10});

    const ShadowRays rays{.sent = 16, .reached = 3};
    const double p = double(rays.reached + 1) / (rays.sent + 2);
    all.push_back({"the factor", double(visibility_error(rays)) * std::pow(rays.sent, 0.75) /
                                     std::pow(p * (1 - p), 0.25)});
    const Estimates anywhere = estimates(-1, 1);
    const Estimates rim = estimates(0.8, 1);
    const auto twentieths = [](double ratio) { return std::round(20 * ratio) / 20; };
    for (const Estimates& ratios : {anywhere, rim}) {
        const auto [least, most] =
            std::minmax_element(ratios.well_spread.begin(), ratios.well_spread.end());
        all.push_back({"the true error is at least so much of the estimate", twentieths(*least)});
        all.push_back({"and at most", twentieths(*most)});
    }
    all.push_back({"the other formula for 1024", anywhere.independent.back()});
    CHECK(says("step11_soft_shadows", "The first is " + decimals(anywhere.independent.front(), 0) +
                                          " times the true error for $n = 8$"));
    return all;
}

}  // namespace rt
