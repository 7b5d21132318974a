// Every number that a page prints is computed again: numbers with a decimal point, a percent or
// degree sign, or a comma between thousands, and some whole numbers. A printed number that is not
// computed fails, and so does a computed one that is not printed.
#include "common/explain/pixel_log.hpp"
#include "common/program/load_meshes.hpp"
#include "common/program/options.hpp"
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step01_ray_generation/ray_generation.hpp"
#include "steps/step02_camera_basis/camera_basis.hpp"
#include "steps/step04_plane/plane.hpp"
#include "steps/step05_triangle/triangle.hpp"
#include "steps/step08_cone/cone.hpp"
#include "steps/step09_phong/phong.hpp"
#include "steps/step10_shadows/shadows.hpp"
#include "steps/step11_soft_shadows/soft_shadows.hpp"
#include "steps/step12_mirror/mirror.hpp"
#include "steps/step13_meshes/meshes.hpp"

#include "tests/documents/page.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <random>
#include <regex>
#include <sstream>

using namespace rt;

namespace {

// Numbers as they are printed.

struct Printed {
    int line;
    std::string text;
    double value;
    double last_digit;  ///< the weight of its last digit
    std::string unit;   ///< "°", "%" or nothing
};

bool is_code(const PageLine& line, const std::vector<PageCode>& codes) {
    return std::any_of(codes.begin(), codes.end(), [&line](const PageCode& code) {
        return line.number >= code.first_line && line.number <= code.last_line;
    });
}

/// A command, a scene or C++, which other parts of this suite run, or a row of stage 10's table,
/// whose rays tests/common/render/contact_test.cpp counts.
bool is_asked_elsewhere(const PageLine& line, const std::vector<PageCode>& codes) {
    static const std::regex elsewhere(
        R"(    (\./course|cmake|gdb|build/|RAYSTEPS_|L |box |mesh |Triangle\{).*)"
        R"(|\| (\$\\varepsilon|\$t > 0\.001\$ \(CR\)|`surface\.error`) .* all .*)");
    return std::regex_match(line.text, elsewhere) || is_code(line, codes);
}

std::vector<Printed> numbers_in(const std::string& text, int line = 0) {
    // Link targets, code, sections of documents, and pixels do not count.
    static const std::regex none(
        R"(\]\([^)]*\)|`[^`]*`|§(\d|\.\d|–)*|(row,column|--pixel) \d+,\d+)");
    static const std::regex each(
        R"((\d{1,3}(?:,\d{3})+|\d+)(\.\d+)?(?: \\cdot 10\^\{(-?\d+)\})?(?: ?(%|°))?)");
    const std::string plain = std::regex_replace(text, none, "_");
    std::vector<Printed> all;
    for (std::sregex_iterator it(plain.begin(), plain.end(), each), end; it != end; ++it) {
        const std::smatch& match = *it;
        const std::string digits = match.str(1);
        const bool is_whole = !match[2].matched && !match[3].matched;
        if (is_whole && !match[4].matched && digits.find(',') == std::string::npos) continue;
        std::string value = digits + match.str(2);
        value.erase(std::remove(value.begin(), value.end(), ','), value.end());
        const double power = match[3].matched ? std::stod("1e" + match.str(3)) : 1;
        const double decimals = match[2].matched ? double(match.length(2) - 1) : 0;
        all.push_back({.line = line,
                       .text = match.str(),
                       .value = std::stod(value) * power,
                       .last_digit = std::pow(10, -decimals) * power,
                       .unit = match.str(4)});
    }
    return all;
}

std::vector<Printed> numbers_of(const std::vector<PageLine>& page) {
    const std::vector<PageCode> codes = code_of(page);
    std::vector<Printed> all;
    for (const PageLine& line : page) {
        if (is_asked_elsewhere(line, codes)) continue;
        const std::vector<Printed> more = numbers_in(line.text, line.number);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

// The computed numbers.

struct Known {
    std::string what;
    double value;
    std::string unit = "";
};

using Knowledge = std::vector<Known>;

/// True if one rounds to the other; the sign is printed before a number, not in it.
bool rounds_to(const Known& known, const Printed& printed) {
    const double value = std::abs(known.value);
    const double slack = printed.last_digit / 2 * (1 + 1e-9) + 4 * double(epsilon) * value;
    return known.unit == printed.unit && std::abs(value - printed.value) <= slack;
}

constexpr double degree = double(pi) / 180;

std::string content(const std::string& name) {
    std::ifstream stream(project_file(name));
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// A page in one line, as sentences run across lines.
std::string sentences(const std::string& page) {
    return std::regex_replace(content("docs/" + page + ".md"), std::regex(R"(\s+)"), " ");
}

Verdict says(const std::string& page, const std::string& sentence) {
    return verdict(sentences(page).find(sentence) != std::string::npos,
                   "docs/" + page + ".md does not say: " + sentence);
}

/// The number between these words in a source.
double said_in(const std::string& file, const std::string& before, const std::string& after) {
    const std::string text = std::regex_replace(content(file), std::regex("\n *///? *"), " ");
    const std::size_t from = text.find(before);
    INFO(file << " does not say \"" << before << "… " << after << "\"");
    REQUIRE(from != std::string::npos);
    std::size_t length = 0;
    const std::string rest = text.substr(from + before.size());
    const double value = std::stod(rest, &length);
    REQUIRE(rest.compare(length, after.size(), after) == 0);
    return value;
}

// CR's printed minimum t of a shadow ray and of a reflected ray, and its listing's factor for
// vertices.
constexpr double cr_shadow_start = 0.001;
constexpr double cr_mirror_start = 0.0001;
constexpr double cr_mesh_scale = 0.0001;

Knowledge stage1() {
    const double fov = 70 * degree;
    const double top = std::tan(fov / 2);
    // Two pixels on a screen from −2 to 2 are 2 wide each.
    const double middle = (pixel_on_screen({}, {2, 1}, pi / 2).x + 2) / 2;
    return {{"how far a pixel's middle is in it", middle},
            {"a field of view", fov / degree, "°"},
            {"seen with half of the screen", 2 * std::atan(top / 2) / degree, "°"},
            {"seen with tan(FOV)", 2 * std::atan(std::tan(fov)) / degree, "°"},
            {"where the screen is as high as it is far", 2 * std::atan(1) / degree, "°"}};
}

Knowledge stage2() {
    const Vec3 pitched(0, std::sin(60 * degree), std::cos(60 * degree));
    const double length_of_x = length(cross(Vec3(0, 1, 0), pitched));
    return {{"‖(0, 1, 0) ∧ Z‖", length_of_x},
            {"the pitch", std::acos(length_of_x) / degree, "°"},
            {"between the lines of the sky",
             said_in("steps/step02_camera_basis/main.cpp", "std::remainder(angle, ", " * degree"),
             "°"}};
}

Knowledge stage4() {
    const Plane plane{.point = {-2, 2, 2}, .normal = {3, 0, 4}};
    const Ray ray{.origin = {2, -3, 1}, .direction = {-1, 2, -3}};
    const Vec3 n = normal(plane, plane.point);
    const Real t = *intersect(ray, plane, {});
    const Vec3 p = at(ray, t);
    CHECK(close(dot(n, ray.direction), -3));
    return {{"n", n.x}, {"n", n.z}, {"⟨r_p − r_0, n⟩", dot(plane.point - ray.origin, n)},
            {"t", t},   {"p", p.x}, {"p", p.y},
            {"p", p.z}};
}

Knowledge stage8() {
    const double r = 1;
    const double h = 2;
    const Cone as_wide_as_high{.apex = {0, 0, 0}, .axis = {0, 0, 1}, .radius = 1, .height = 1};
    const double across = dot(normal(as_wide_as_high, {1, 0, 1}), Vec3(1, 0, 0));
    return {{"as printed, at z = h", std::sqrt(r / h) * h},
            {"how far the normal leans back", std::acos(across) / degree, "°"}};
}

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
    return {
        {"the least t (CR §3.2)", cr_shadow_start},
        {"u by which a point is off", said_in(source, "error of a point is at most ", ",")},
        {"where the ray ends before the ceiling", std::asin(flat_is_off / before) / degree, "°"},
        {"the largest of the constants", too_large},
        {"half of it", too_large / 2}};
}

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
    const auto centred = [](Vec3 /*from*/, Vec2 sample) {
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
            {"flat, centred", passing(x, centred)}};
}

/// The ratio of the estimates to the true error for 8, 16, … 1024 rays, as root mean squares over
/// straight edges at these distances from the middle of a disc.
struct Estimates {
    std::vector<double> even;         ///< true error / visibility_error
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
        result.even.push_back(std::sqrt(ratios[k]));
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

std::string decimals(double value, int digits) {
    std::ostringstream out;
    out << std::fixed;
    out.precision(digits);
    out << value;
    return out.str();
}

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

Knowledge stage11() {
    Knowledge all = light_shares();
    const std::vector<Row> table = soft_shadow_table();
    for (const Row& row : table) {
        const std::string told = "| `" + row.option + "` | " + decimals(row.drawn.rays, 1) + " | " +
                                 decimals(row.errors.root_mean_square, 4) + " | " +
                                 decimals(row.errors.largest, 3) + " |";
        CHECK(says("step11_soft_shadows", told));
        for (const Printed& number : numbers_in(told)) all.push_back({row.option, number.value});
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
        const auto [least, most] = std::minmax_element(ratios.even.begin(), ratios.even.end());
        all.push_back({"the true error is at least so much of the estimate", twentieths(*least)});
        all.push_back({"and at most", twentieths(*most)});
    }
    all.push_back({"the other formula for 1024", anywhere.independent.back()});
    CHECK(says("step11_soft_shadows", "The first is " + decimals(anywhere.independent.front(), 0) +
                                          " times the true error for $n = 8$"));
    return all;
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
            {"what they show", 100 * (1 - std::pow(m, depth + 1)), "%"}};
}

/// The number of triangles in a mesh of the scene, as read from the file.
double triangles(const Scene& scene, const std::string& file) {
    for (std::size_t i = 0; i < scene.mesh_requests.size(); ++i)
        if (scene.mesh_requests[i].file == file)
            return double(
                (scene.meshes.begin() + std::ptrdiff_t(i))->shape.model->mesh.triangles.size());
    return 0;
}

Knowledge stage13() {
    Scene scene = load_scene(project_file("scenes/step13_meshes.rt"), orthonormal_basis);
    load_meshes(scene);
    build_acceleration(scene);
    // Every fourth pixel is enough for two digits.
    const auto pixel_ray = pixel_rays(scene.cameras.front(), scene.resolution);
    Context context;
    for (Pixel& pixel = context.pixel; pixel.row < scene.resolution.height; pixel.row += 2)
        for (pixel.column = 0; pixel.column < scene.resolution.width; pixel.column += 2)
            (void)trace(scene, pixel_ray(pixel), context);
    CHECK(says("step13_meshes",
               "with " + decimals(triangles(scene, "meshes/owl_cage.obj"), 0) + " and none."));
    return {{"an owl's triangles", triangles(scene, "meshes/owl.off")},
            {"millions of rays", 4e-6 * double(context.rays)},
            {"the scale of CR's listing", cr_mesh_scale},
            {"what is two wide, so scaled", 2 * cr_mesh_scale},
            {"the least t (CR §4.2)", cr_shadow_start},
            {"half-way between normals at right angles", length(Vec3(1, 1, 0) / Real(2))}};
}

Knowledge debugging() {
    const Triangle triangle{.a = {0, 0, 0}, .b = {4, 0, 0}, .c = {0, 4, 0}};
    const Vec3 weights = barycentric(triangle, {3, 3, 0});
    Knowledge all = {{"β", weights.y},
                     {"β + γ", weights.y + weights.z},
                     {"t of the random case, where z is 2.25", 2.25 / (18 / 17.0)}};

    const Triangle round{.a = {0, 0, 0}, .b = {3, 0, 17}, .c = {1, 0, 0}};
    const Ray from_above{.origin = {0, 31, -24}, .direction = {Real(0.375), -8, 8}};
    const double t = *intersect(from_above, round, {});
    const double too_long = 1.01;
    all.push_back({"too long", 100 * (too_long - 1), "%"});
    all.push_back({"t", t});
    all.push_back({"t, too long", t * too_long});

    const Scene scene = load_scene(project_file("scenes/step05_triangle.rt"), orthonormal_basis);
    const Ray ray = pixel_rays(scene.cameras.front(), scene.resolution)({231, 398});
    const Triangle& seen = (scene.triangles.begin() + 4)->shape;
    CHECK(content("docs/debugging.md").find(code(seen)) != std::string::npos);
    std::ostringstream log;
    PixelLog teller(log);
    explain(teller, ray, seen);
    for (const Printed& number : numbers_in(log.str()))
        all.push_back({"the story of pixel 231,398", number.value});
    return all;
}

struct Page {
    std::string name;
    Knowledge (*know)();
};

Knowledge nothing() {
    return {};
}

const Page pages[] = {
    {"step01_ray_generation", stage1}, {"step02_camera_basis", stage2},  {"step03_sphere", nothing},
    {"step04_plane", stage4},          {"step05_triangle", nothing},     {"step06_square", nothing},
    {"step07_cylinder", nothing},      {"step08_cone", stage8},          {"step09_phong", stage9},
    {"step10_shadows", stage10},       {"step11_soft_shadows", stage11}, {"step12_mirror", stage12},
    {"step13_meshes", stage13},        {"debugging", debugging},
};

Verdict is_known(const Printed& printed, const Page& page, const Knowledge& all) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const Known& each) { return rounds_to(each, printed); });
    return verdict(known, "docs/" + page.name + ".md:" + std::to_string(printed.line) + ": " +
                              printed.text + " is not the value computed here");
}

Verdict is_printed(const Known& known, const Page& page, const std::vector<Printed>& all) {
    const bool printed = std::any_of(all.begin(), all.end(),
                                     [&](const Printed& each) { return rounds_to(known, each); });
    return verdict(printed, "docs/" + page.name + ".md does not print " + text(Real(known.value)) +
                                known.unit + ", " + known.what);
}

}  // namespace

TEST_CASE("a page's sentences with whole numbers are true") {
    // Situation B (PHY), with the given center and with the one that its solution uses.
    const auto situation_b = [](Vec3 center) {
        const Vec3 v(0, -3, 5);
        const Vec3 r = Vec3(3, 2, 0) - center;
        return std::array{dot(v, v), 2 * dot(r, v), dot(r, r) - 9};
    };
    const auto discriminant = [](std::array<Real, 3> q) { return q[1] * q[1] - 4 * q[0] * q[2]; };
    const auto given = situation_b({1, 0, -3});
    const auto worked = situation_b({1, -3, 0});
    const auto dollars = [](Real number) { return "$" + text(number) + "$"; };
    CHECK(says("step03_sphere",
               "As given, $A = " + text(given[0]) + "$, $B = " + text(given[1]) +
                   "$, $C = " + text(given[2]) + "$ and the discriminant is " +
                   dollars(discriminant(given)) + "; as worked, $B = " + text(worked[1]) +
                   "$, $C = " + text(worked[2]) + "$ and " + dollars(discriminant(worked)) + "."));
    const Vec3 d(1, -1, 0);
    const Vec3 n(0, 2, 0);
    CHECK(says("step12_mirror", "it gives $" + text(d - 2 * dot(d, n) * n) + "$"));
    CHECK(says("step01_ray_generation", "640 / 480 is " + std::to_string(640 / 480)));
}

TEST_CASE("the table of costs in stage 5's page is the one that is counted") {
    // tests/documents/triangle_costs_test.cpp tests each row: "42 | 49 | 1 | 0".
    const std::string source = content("tests/documents/triangle_costs_test.cpp");
    const std::regex row(R"re("(\d+ \| \d+ \| \d+ \| \d+)")re");
    int rows = 0;
    for (std::sregex_iterator it(source.begin(), source.end(), row), end; it != end; ++it, ++rows)
        CHECK(says("step05_triangle", "| " + it->str(1) + " |"));
    CHECK(rows == 6);
}

TEST_CASE("every number of a page is worked out again, and is that") {
    for (const Page& page : pages) {
        const std::vector<Printed> printed =
            numbers_of(read_page(project_file("docs/" + page.name + ".md")));
        const Knowledge known = page.know();
        for (const Printed& each : printed) CHECK(is_known(each, page, known));
        for (const Known& each : known) CHECK(is_printed(each, page, printed));
    }
}

TEST_CASE("numbers are recognized and compared (this suite)") {
    const std::vector<Printed> all = numbers_in(
        "CR §2.1: [at 0.5](a1.5.md) it is `0.7`, and 1,234 of 5, 61 %, $6 \\cdot 10^{-8}$");
    REQUIRE(all.size() == 4);
    CHECK(all[0].text == "0.5");
    CHECK(rounds_to({"", 1234}, all[1]));
    CHECK(rounds_to({"", 61.4, "%"}, all[2]));
    CHECK_FALSE(rounds_to({"", 61.6, "%"}, all[2]));
    CHECK_FALSE(rounds_to({"", 61.4}, all[2]));
    CHECK(rounds_to({"", 5.96e-8}, all[3]));
    CHECK_FALSE(rounds_to({"", 5e-8}, all[3]));
}

TEST_CASE("all C++ of the pages is compiled in this suite") {
    // The output of a compiler or a debugger has the line's number before the code.
    const std::regex code(R"(    (?! *\d+[ \t]).*[;{}])");
    const std::regex data(R"(    +(Triangle\{|Value returned|//).*)");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("docs"))) {
        if (entry.path().extension() != ".md") continue;
        const std::vector<PageLine> page = read_page(entry.path());
        const std::vector<PageCode> codes = code_of(page);
        for (const PageLine& line : page) {
            const bool left_out = std::regex_match(line.text, code) &&
                                  !std::regex_match(line.text, data) && !is_code(line, codes);
            CHECK(verdict(!left_out && line.text.rfind("```", 0) != 0,
                          entry.path().filename().string() + ":" + std::to_string(line.number) +
                              ": C++ that is not compiled: " + line.text));
        }
    }
}
